package argo.filters.format

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.Deadband
import argo.filters.FilterException
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.PerceptionFilter.OnSwitch
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.TermTest
import argo.filters.format.FilterNode.Member
import argo.filters.format.FilterNode.Scalar

/**
 * Reads a filter from the tree that [parse] makes of a document.
 *
 * @throws FilterException with all problems of the document, in the order of the text
 */
internal fun readFilter(source: String, name: String, parse: (Problems) -> FilterNode?): PerceptionFilter {
    val problems = Problems(source)
    val filter = parse(problems)?.let(FilterReader(problems, name)::filter)
    problems.throwIfAny()
    return checkNotNull(filter) { "a document without problems is a filter" }
}

/** Makes a filter called [name] from a document's tree. Reports wrong parts to [problems] and leaves them out. */
internal class FilterReader(private val problems: Problems, private val name: String) {

    fun filter(node: FilterNode): PerceptionFilter? {
        val members = members(node, "a filter", RULES, CRITICAL, KEEP, ON_SWITCH) ?: return null
        if (RULES !in members) report(node.position, "the filter has no \"$RULES\"; expected an array of rules, which may be empty")
        val keep = scalar(members[KEEP], Scalar::isBare, "true or false") { it.trim().toBooleanStrictOrNull() } ?: false
        val onSwitch = scalar(members[ON_SWITCH], Scalar::isText, "forget or freeze") { written ->
            OnSwitch.entries.find { it.name.lowercase() == written.trim() }
        }
        val rules = items(members[RULES]).mapNotNull(::rule)
        val critical = items(members[CRITICAL]).mapNotNull(::criticalRule)
        return PerceptionFilter(name, rules, if (keep) Mode.KEEP else Mode.DROP, onSwitch ?: OnSwitch.FORGET, critical)
    }

    private fun rule(node: FilterNode): Rule? {
        val members = members(node, "a rule", PREDICATE, CONDITIONS, ARITY, EVERY_MS, DEADBAND) ?: return null
        val deadbands = LinkedHashMap<Int?, Deadband>()
        members[DEADBAND]?.let { deadband(it, null, deadbands) }
        val rule = rule(node, members, deadbands)
        val everyMs = wholeNumber(members[EVERY_MS], 1..Long.MAX_VALUE)
        val rate = if (everyMs == null && deadbands.isEmpty()) null else Rate(everyMs, deadbands.values.toSet())
        return rule?.copy(rate = rate)
    }

    private fun criticalRule(node: FilterNode): CriticalRule? {
        val members = members(node, "a critical rule", PREDICATE, CONDITIONS, ARITY, REFLEX) ?: return null
        val rule = rule(node, members, null)
        val reflex = members[REFLEX]?.let { member ->
            text(member)?.let { text -> problems.reporting(member.value.position) { text.also(CriticalRule::requireSendable) } }
        }
        return rule?.let { CriticalRule(it, reflex) }
    }

    /** Returns the rule without its rate. Deadbands of its arguments go to [deadbands]; if that is null, they are refused. */
    private fun rule(node: FilterNode, members: Map<String, Member>, deadbands: MutableMap<Int?, Deadband>?): Rule? {
        if (PREDICATE !in members) report(node.position, "the rule has no \"$PREDICATE\"; expected one, as in \"$PREDICATE\": \"dist\"")
        val conditions = items(members[CONDITIONS]).mapNotNull { condition(it, deadbands) }
        val arity = index(members[ARITY])
        return predicate(members[PREDICATE], "predicate")?.let { Rule(it, conditions, arity) }
    }

    private fun predicate(member: Member?, what: String): Predicate? {
        val text = text(member) ?: return null
        val expectation = if (text.isBlank()) "the $what is empty" else "as the $what, only the functor is expected"
        return member?.let { problems.reporting(it.value.position, expectation) { Predicate.of(text) } }
    }

    private fun condition(node: FilterNode, deadbands: MutableMap<Int?, Deadband>?): Condition? {
        val members = members(node, "a condition", ARGUMENT, ANNOTATION, OPERATOR, VALUE, LIMITS, DEADBAND) ?: return null
        if ((ARGUMENT in members) == (ANNOTATION in members)) {
            report(node.position, "the condition has both or neither of \"$ARGUMENT\" and \"$ANNOTATION\"; expected one of them")
            return null
        }
        return if (ARGUMENT in members) argument(node, members, deadbands) else annotation(node, members)
    }

    private fun argument(node: FilterNode, members: Map<String, Member>, deadbands: MutableMap<Int?, Deadband>?): Condition? {
        refuse(members, LIMITS, "an argument")
        val index = index(members[ARGUMENT])
        val deadband = members[DEADBAND]
        if (deadband != null) {
            if (deadbands == null) report(deadband.position, "a deadband in a critical rule; a critical percept is never held back")
            else if (index != null) deadband(deadband, index, deadbands)
            if (OPERATOR !in members && VALUE !in members) return null
        }
        val test = test(node, members)
        return if (index == null || test == null) null else Condition.Argument(index, test)
    }

    private fun deadband(member: Member, index: Int?, deadbands: MutableMap<Int?, Deadband>) {
        val width = scalar(member, Scalar::isBare, "a number above 0, by which the argument must move") { written ->
            (GroundTerm.ofOrNull(written) as? GroundTerm.Number)?.value?.takeIf { it > 0 && it.isFinite() }
        } ?: return
        val earlier = deadbands.put(index, Deadband(index, width))
        if (earlier != null) report(member.position, "a second deadband for the argument $index; expected one")
    }

    private fun annotation(node: FilterNode, members: Map<String, Member>): Condition? {
        refuse(members, DEADBAND, "an annotation")
        val tests = when {
            LIMITS in members -> limits(members)
            OPERATOR in members || VALUE in members -> listOfNotNull(test(node, members))
            else -> emptyList()
        }
        return predicate(members[ANNOTATION], "annotation's name")?.let { Condition.Annotation(it, tests) }
    }

    private fun limits(members: Map<String, Member>): List<TermTest> {
        refuse(members, OPERATOR, "an annotation with \"$LIMITS\"")
        refuse(members, VALUE, "an annotation with \"$LIMITS\"")
        return items(members[LIMITS]).mapNotNull { limit -> members(limit, "a limit", OPERATOR, VALUE)?.let { test(limit, it) } }
    }

    private fun test(node: FilterNode, members: Map<String, Member>): TermTest? {
        val operator = operator(members[OPERATOR])
        val value = members[VALUE]?.value
        if (value == null) report(node.position, "there is no \"$VALUE\" to compare with")
        if (operator == null || value == null || value is FilterNode.Refused) return null
        return problems.reporting(value.position) { TestFormat.test(operator, written(value, operator)) }
    }

    private fun operator(member: Member?): String? {
        val written = text(member ?: return Operator.EQ.name) ?: return null
        val operator = TestFormat.operator(written)
        if (operator == null) report(member.value.position, "the operator '$written'; expected ${TestFormat.NAMES}")
        return operator
    }

    /** Returns [value] in Jason's syntax: a number or a text as it is, an array as a list of values. */
    private fun written(value: FilterNode, operator: String): String = when {
        value is Scalar && (value.isText || NUMBER.matches(value.content)) -> value.content
        value is FilterNode.Array && operator == TestFormat.IN -> value.items.joinToString(",", "[", "]") { written(it, "") }
        else -> throw IllegalArgumentException(
            "the value is ${value.words}; expected a number or text with a Jason term, as in \"front\" or \"\\\"a string\\\"\"",
        )
    }

    private fun index(member: Member?): Int? = wholeNumber(member, 0..Int.MAX_VALUE.toLong())?.toInt()

    private fun wholeNumber(member: Member?, range: LongRange): Long? =
        scalar(member, Scalar::isBare, "a whole number from ${range.first}") { written ->
            written.trim().takeIf { number -> number.all { it in '0'..'9' } }?.toLongOrNull()?.takeIf { it in range }
        }

    private fun text(member: Member?): String? = scalar(member, Scalar::isText, "text") { it }

    /** Applies [read] to a scalar of the right kind. Reports values of another kind, and those for which [read] returns null. */
    private fun <T> scalar(member: Member?, isOfKind: (Scalar) -> Boolean, expected: String, read: (String) -> T?): T? {
        if (member == null || member.value is FilterNode.Refused) return null
        val found = (member.value as? Scalar)?.takeIf(isOfKind)?.let { read(it.content) }
        if (found == null) report(member.value.position, "${member.words}; expected $expected")
        return found
    }

    private fun items(member: Member?): List<FilterNode> {
        val value = member?.value ?: return emptyList()
        if (value is FilterNode.Array) return value.items
        report(value.position, "${member.words}; expected an array")
        return emptyList()
    }

    /** Returns the members of [node] by name; null if [node] is no object. Reports members that are not [known] or come twice. */
    private fun members(node: FilterNode, what: String, vararg known: String): Map<String, Member>? {
        if (node !is FilterNode.Object) {
            report(node.position, "${node.words} where $what is expected, an object with ${known.joinToString(" or ")}")
            return null
        }
        val members = LinkedHashMap<String, Member>()
        for (member in node.members) {
            if (member.name !in known) report(member.position, "\"${member.name}\" in $what; expected ${known.joinToString(" or ")}")
            if (members.put(member.name, member) != null) report(member.position, "a second \"${member.name}\" in $what; expected one")
        }
        return members
    }

    private fun refuse(members: Map<String, Member>, name: String, what: String) {
        members[name]?.let { report(it.position, "\"$name\" on $what, which has none") }
    }

    private fun report(at: Position, message: String) = problems.report(at, message)

    companion object {
        const val RULES = "rules"
        const val CRITICAL = "critical"
        const val REFLEX = "reflex"
        const val KEEP = "keep"
        const val ON_SWITCH = "onSwitch"
        const val PREDICATE = "predicate"
        const val CONDITIONS = "conditions"
        const val ARITY = "arity"
        const val EVERY_MS = "everyMs"
        const val DEADBAND = "deadband"
        const val ARGUMENT = "argument"
        const val ANNOTATION = "annotation"
        const val OPERATOR = "operator"
        const val VALUE = "value"
        const val LIMITS = "limits"
        private val NUMBER = Regex("-?\\d.*")
    }
}
