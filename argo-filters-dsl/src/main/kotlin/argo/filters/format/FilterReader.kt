package argo.filters.format

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.Deadband
import argo.filters.FilterException
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.Outliers
import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.PerceptionFilter.OnSwitch
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.SmoothingRule
import argo.filters.TermTest
import argo.filters.format.FilterNode.Member
import argo.filters.format.FilterNode.Scalar

/**
 * Reads a filter from the tree that [parse] makes from a document.
 *
 * @throws FilterException with all problems of the document, in the order of the text
 */
internal fun readFilter(source: String, name: String, parse: (Problems) -> FilterNode?): PerceptionFilter {
    val problems = Problems(source)
    val filter = parse(problems)?.let(FilterReader(problems, name)::filter)
    problems.throwIfAny()
    return checkNotNull(filter) { "a document without problems is a filter" }
}

/** Makes a filter called [name] from a document's tree. Reports wrong parts to [problems] and skips them. */
internal class FilterReader(private val problems: Problems, private val name: String) {
    /** Further members of an argument, outside of conditions: their [names], and the function [read], which reads them. */
    private class Besides(val names: List<String>, val read: (members: Map<String, Member>, index: Int?) -> Unit)

    fun filter(node: FilterNode): PerceptionFilter? {
        val members = members(node, "a filter", RULES, CRITICAL, SMOOTH, KEEP, ON_SWITCH) ?: return null
        if (RULES !in members) report(node.position, "the filter has no \"$RULES\"; expected an array of rules, which may be empty")
        val keep = truth(members[KEEP])
        val onSwitch = scalar(members[ON_SWITCH], Scalar::isText, "forget or freeze") { written ->
            OnSwitch.entries.find { it.name.lowercase() == written.trim() }
        }
        val rules = items(members[RULES]).mapNotNull(::rule)
        val critical = items(members[CRITICAL]).mapNotNull(::criticalRule)
        val smoothing = items(members[SMOOTH]).mapNotNull(::smoothingRule)
        return PerceptionFilter(name, rules, if (keep) Mode.KEEP else Mode.DROP, onSwitch ?: OnSwitch.FORGET, critical, smoothing)
    }

    private fun rule(node: FilterNode): Rule? {
        val members = members(node, "a rule", PREDICATE, CONDITIONS, ARITY, EVERY_MS, DEADBAND) ?: return null
        val deadbands = LinkedHashMap<Int?, Deadband>()
        members[DEADBAND]?.let { deadband(it, null, deadbands) }
        val rule = rule(node, members, Besides(listOf(DEADBAND)) { said, index ->
            if (index != null) deadband(said.getValue(DEADBAND), index, deadbands)
        })
        val everyMs = wholeNumber(members[EVERY_MS], 1..Long.MAX_VALUE)
        val rate = if (everyMs == null && deadbands.isEmpty()) null else Rate(everyMs, deadbands.values.toSet())
        return rule?.copy(rate = rate)
    }

    private fun criticalRule(node: FilterNode): CriticalRule? {
        val members = members(node, "a critical rule", PREDICATE, CONDITIONS, ARITY, REFLEX, SMOOTHED) ?: return null
        val rule = rule(node, members, Besides(listOf(DEADBAND)) { said, _ ->
            report(said.getValue(DEADBAND).position, "a deadband in a critical rule; a critical percept is never held back")
        })
        val reflex = members[REFLEX]?.let { member ->
            text(member)?.let { text -> problems.reporting(member.value.position) { text.also(CriticalRule::requireSendable) } }
        }
        val smoothed = truth(members[SMOOTHED])
        return rule?.let { CriticalRule(it, reflex, smoothed) }
    }

    private fun smoothingRule(node: FilterNode): SmoothingRule? {
        val members = members(node, "a smoothing rule", PREDICATE, CONDITIONS, ARITY, ANNOTATE) ?: return null
        val smoothed = ArrayList<Pair<Int?, Map<String, Member>>>()
        val rule = rule(node, members, Besides(SMOOTHING) { said, index -> smoothed += index to said })
        val annotates = truth(members[ANNOTATE])
        smoothed.drop(1).forEach { (_, said) ->
            report(said.getValue(ARGUMENT).position, "a second argument that is smoothed; expected one, and another rule for the other")
        }
        val (index, said) = smoothed.firstOrNull() ?: run {
            report(node.position, "the rule smooths no argument; expected ${SMOOTHING.joinToString(" or ")} of one")
            return null
        }
        val outliers = outliers(said)
        val maxRate = positive(said[MAX_RATE], "by which the argument can change in a second")
        val median = window(said[MEDIAN])
        if (rule == null || index == null || maxRate == null && outliers == null && median == null) return null
        return problems.reporting(node.position) { SmoothingRule(rule, index, maxRate, outliers, median, annotates) }
    }

    private fun outliers(said: Map<String, Member>): Outliers? {
        if (OUTLIERS !in said) said[AMONG]?.let { report(it.position, "\"$AMONG\" without \"$OUTLIERS\", whose number of percepts it is") }
        val deviations = scalar(said[OUTLIERS], Scalar::isBare, "a number of deviations from 1, as in 3") { written ->
            number(written)?.takeIf { it >= 1 && it.isFinite() }
        }
        val among = window(said[AMONG]) ?: Outliers.AMONG
        return deviations?.let { Outliers(it, among) }
    }

    private fun window(member: Member?): Int? =
        scalar(member, Scalar::isBare, SmoothingRule.WINDOW) { it.trim().toIntOrNull()?.takeIf(SmoothingRule::isWindow) }

    /** Returns the rule without its rate. [besides] reads members of arguments outside of conditions. */
    private fun rule(node: FilterNode, members: Map<String, Member>, besides: Besides): Rule? {
        if (PREDICATE !in members) report(node.position, "the rule has no \"$PREDICATE\"; expected one, as in \"$PREDICATE\": \"dist\"")
        val conditions = items(members[CONDITIONS]).mapNotNull { condition(it, besides) }
        val arity = index(members[ARITY])
        return predicate(members[PREDICATE], "predicate")?.let { Rule(it, conditions, arity) }
    }

    private fun predicate(member: Member?, what: String): Predicate? {
        val text = text(member) ?: return null
        val expectation = if (text.isBlank()) "the $what is empty" else "as the $what, only the functor is expected"
        return member?.let { problems.reporting(it.value.position, expectation) { Predicate.of(text) } }
    }

    /** Returns the condition of [node]. Returns null if [node] has no condition, or if the condition is refused. */
    private fun condition(node: FilterNode, besides: Besides): Condition? {
        val known = listOf(ARGUMENT, ANNOTATION, OPERATOR, VALUE, UNTIL, LIMITS) + besides.names
        val members = members(node, "a condition", *known.toTypedArray()) ?: return null
        if ((ARGUMENT in members) == (ANNOTATION in members)) {
            report(node.position, "the condition has both or neither of \"$ARGUMENT\" and \"$ANNOTATION\"; expected one of them")
            return null
        }
        return if (ARGUMENT in members) argument(node, members, besides) else annotation(node, members, besides)
    }

    private fun argument(node: FilterNode, members: Map<String, Member>, besides: Besides): Condition? {
        refuse(members, LIMITS, "an argument")
        val index = index(members[ARGUMENT])
        if (besides.names.any(members::containsKey)) {
            besides.read(members, index)
            if (OPERATOR !in members && VALUE !in members && UNTIL !in members) return null
        }
        val test = test(node, members)
        val until = scalar(members[UNTIL], Scalar::isBare, "a number, the second limit", ::number)
        if (index == null || test == null) return null
        val at = members[UNTIL]?.value?.position ?: node.position
        return problems.reporting(at) { Condition.Argument(index, test, until) }
    }

    private fun deadband(member: Member, index: Int?, deadbands: MutableMap<Int?, Deadband>) {
        val width = positive(member, "by which the argument must move") ?: return
        val earlier = deadbands.put(index, Deadband(index, width))
        if (earlier != null) report(member.position, "a second deadband for the argument $index; expected one")
    }

    private fun annotation(node: FilterNode, members: Map<String, Member>, besides: Besides): Condition? {
        (besides.names + UNTIL).forEach { refuse(members, it, "an annotation") }
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
        return problems.reporting(value.position) { OperatorFormat.test(operator, written(value, operator)) }
    }

    private fun operator(member: Member?): String? {
        val written = text(member ?: return Operator.EQ.name) ?: return null
        val operator = OperatorFormat.operator(written)
        if (operator == null) report(member.value.position, "the operator '$written'; expected ${OperatorFormat.NAMES}")
        return operator
    }

    /** Returns [value] in Jason's syntax. A number or text stays as it is. An array becomes a list of values. */
    private fun written(value: FilterNode, operator: String): String = when {
        value is Scalar && (value.isText || NUMBER.matches(value.content)) -> value.content
        value is FilterNode.Array && operator == OperatorFormat.IN -> value.items.joinToString(",", "[", "]") { written(it, "") }
        else -> throw IllegalArgumentException(
            "the value is ${value.words}; expected a number or text with a Jason term, as in \"front\" or \"\\\"a string\\\"\"",
        )
    }

    private fun index(member: Member?): Int? = wholeNumber(member, 0..Int.MAX_VALUE.toLong())?.toInt()

    private fun wholeNumber(member: Member?, range: LongRange): Long? =
        scalar(member, Scalar::isBare, "a whole number from ${range.first}") { written ->
            written.trim().takeIf { number -> number.all { it in '0'..'9' } }?.toLongOrNull()?.takeIf { it in range }
        }

    private fun truth(member: Member?): Boolean =
        scalar(member, Scalar::isBare, "true or false") { it.trim().toBooleanStrictOrNull() } ?: false

    private fun positive(member: Member?, meaning: String): Double? =
        scalar(member, Scalar::isBare, "a finite number above 0, $meaning") { written ->
            number(written)?.takeIf { it > 0 && it.isFinite() }
        }

    private fun number(written: String): Double? = (GroundTerm.ofOrNull(written) as? GroundTerm.Number)?.value

    private fun text(member: Member?): String? = scalar(member, Scalar::isText, "text") { it }

    /** Applies [read] to a scalar of the right kind. Reports any other value, and any value for which [read] returns null. */
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

    /** Returns the members of [node] by name. Returns null if [node] is no object. Reports unknown and repeated members. */
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
        const val UNTIL = "until"
        const val SMOOTH = "smooth"
        const val SMOOTHED = "smoothed"
        const val ANNOTATE = "annotate"
        const val MAX_RATE = "maxRate"
        const val OUTLIERS = "outliers"
        const val AMONG = "among"
        const val MEDIAN = "median"

        /** The members that define how an argument is smoothed. */
        val SMOOTHING = listOf(MAX_RATE, OUTLIERS, AMONG, MEDIAN)
        private val NUMBER = Regex("-?\\d.*")
    }
}
