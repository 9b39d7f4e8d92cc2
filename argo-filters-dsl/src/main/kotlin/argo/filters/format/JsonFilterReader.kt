package argo.filters.format

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.Deadband
import argo.filters.FilterException
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.PerceptionFilter.OnSwitch
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.TermTest

/** Makes a filter of a JSON document, or a list of all that is wrong with it. */
internal class JsonFilterReader(text: String, source: String, private val name: String) {
    private val root = JsonTreeReader(text, source).read()
    private val problems = Problems(source)

    /** @throws FilterException with all problems of the document, in the order of the text */
    fun read(): PerceptionFilter = problems.unlessAny(filter(root))

    private fun filter(node: JsonNode): PerceptionFilter? {
        val members = members(node, "a filter", RULES, CRITICAL, KEEP, ON_SWITCH) ?: return null
        val keep = oneOf(members[KEEP], false, FilterWords.MODES) ?: Mode.DROP
        val onSwitch = oneOf(members[ON_SWITCH], true, FilterWords.ON_SWITCHES) ?: OnSwitch.FORGET
        if (RULES !in members) report(node.position, "the filter has no \"$RULES\"; expected an array of rules, which may be empty")
        val critical = items(members[CRITICAL]).mapNotNull(::criticalRule)
        return PerceptionFilter(name, items(members[RULES]).mapNotNull(::rule), keep, onSwitch, critical)
    }

    private fun <T> oneOf(member: JsonNode.Member?, isText: Boolean, words: Map<String, T>): T? {
        val value = member?.value ?: return null
        val found = (value as? JsonNode.Scalar)?.takeIf { it.isText == isText }?.let { words[it.content] }
        if (found == null) report(value.position, "\"${member.name}\" is ${value.words}; expected ${words.keys.joinToString(" or ")}")
        return found
    }

    private fun rule(node: JsonNode): Rule? {
        val members = members(node, "a rule", PREDICATE, CONDITIONS, ARITY, EVERY_MS, DEADBAND) ?: return null
        val predicate = predicate(node, members)
        val deadbands = LinkedHashMap<Int?, Deadband>()
        members[DEADBAND]?.let { deadband(it, null) }?.let { deadbands[null] = it }
        val conditions = items(members[CONDITIONS]).mapNotNull { condition(it, deadbands) }
        val arity = wholeNumber(members[ARITY], 0)?.toInt()
        val everyMs = wholeNumber(members[EVERY_MS], 1, Long.MAX_VALUE)
        val rate = if (everyMs == null && deadbands.isEmpty()) null else Rate(everyMs, deadbands.values.toSet())
        return predicate?.let { Rule(it, conditions, arity, rate) }
    }

    private fun criticalRule(node: JsonNode): CriticalRule? {
        val members = members(node, "a critical rule", PREDICATE, CONDITIONS, ARITY, REFLEX) ?: return null
        val predicate = predicate(node, members)
        val conditions = items(members[CONDITIONS]).mapNotNull {
            val deadband = (it as? JsonNode.Object)?.members?.find { member -> member.name == DEADBAND }
            if (deadband != null) report(deadband.position, "a \"$DEADBAND\" in a critical rule; a critical percept is never held back")
            condition(it, HashMap())
        }
        val arity = wholeNumber(members[ARITY], 0)?.toInt()
        val reflex = members[REFLEX]?.let(::reflex)
        val isRefused = predicate == null || REFLEX in members && reflex == null
        return if (isRefused) null else CriticalRule(Rule(predicate, conditions, arity), reflex)
    }

    private fun reflex(member: JsonNode.Member): String? {
        val text = text(member) ?: return null
        return reporting(member.value) { text.also(CriticalRule::requireSendable) }
    }

    private fun predicate(node: JsonNode, members: Map<String, JsonNode.Member>): Predicate? {
        if (PREDICATE !in members) report(node.position, "the rule has no \"$PREDICATE\"; expected one, as in \"$PREDICATE\": \"dist\"")
        return predicate(members[PREDICATE])
    }

    private fun predicate(member: JsonNode.Member?): Predicate? {
        val text = text(member ?: return null) ?: return null
        return reporting(member.value) { Predicate.of(text) }
    }

    /** The condition that [node] is; null if it is but a deadband, which goes to [deadbands], or is refused. */
    private fun condition(node: JsonNode, deadbands: MutableMap<Int?, Deadband>): Condition? {
        val members = members(node, "a condition", ARGUMENT, ANNOTATION, OPERATOR, VALUE, LIMITS, DEADBAND) ?: return null
        return when {
            (ARGUMENT in members) == (ANNOTATION in members) -> {
                report(node.position, "the condition has both or neither of \"$ARGUMENT\" and \"$ANNOTATION\"; expected one of them")
                null
            }
            ARGUMENT in members -> argument(node, members, deadbands)
            else -> annotation(node, members)
        }
    }

    private fun argument(node: JsonNode, members: Map<String, JsonNode.Member>, deadbands: MutableMap<Int?, Deadband>): Condition? {
        refuse(members, LIMITS, "an argument")
        val index = wholeNumber(members[ARGUMENT], 0)?.toInt()
        members[DEADBAND]?.let { deadbandOf(it, index, deadbands) }
        if (DEADBAND in members && OPERATOR !in members && VALUE !in members) return null
        val test = test(node, members)
        return if (index == null || test == null) null else Condition.Argument(index, test)
    }

    private fun deadbandOf(member: JsonNode.Member, index: Int?, deadbands: MutableMap<Int?, Deadband>) {
        if (index == null) return
        if (index in deadbands) report(member.position, "a second deadband for the argument $index; expected one")
        deadband(member, index)?.let { deadbands[index] = it }
    }

    private fun annotation(node: JsonNode, members: Map<String, JsonNode.Member>): Condition? {
        refuse(members, DEADBAND, "an annotation")
        val name = predicate(members[ANNOTATION])
        val tests = when {
            LIMITS in members -> limits(members)
            OPERATOR in members || VALUE in members -> listOf(test(node, members))
            else -> emptyList()
        }
        return if (name == null || null in tests) null else Condition.Annotation(name, tests.filterNotNull())
    }

    private fun limits(members: Map<String, JsonNode.Member>): List<TermTest?> {
        refuse(members, OPERATOR, "an annotation with \"$LIMITS\"")
        refuse(members, VALUE, "an annotation with \"$LIMITS\"")
        return items(members[LIMITS]).map { limit -> members(limit, "a limit", OPERATOR, VALUE)?.let { test(limit, it) } }
    }

    private fun test(node: JsonNode, members: Map<String, JsonNode.Member>): TermTest? {
        val operator = operator(members[OPERATOR])
        val value = members[VALUE]?.value
        if (value == null) report(node.position, "there is no \"$VALUE\" to compare with")
        return if (operator == null || value == null) null else reporting(value) { TestFormat.test(operator, written(value, operator)) }
    }

    private fun operator(member: JsonNode.Member?): String? {
        val written = text(member ?: return Operator.EQ.name) ?: return null
        val operator = TestFormat.operator(written)
        if (operator == null) report(member.value.position, "the operator '$written'; expected ${TestFormat.NAMES}")
        return operator
    }

    /** A value as Jason's text: JSON's numbers stand for themselves, its strings for the text of a term, its arrays for lists of values. */
    private fun written(value: JsonNode, operator: String): String = when {
        value is JsonNode.Scalar && (value.isText || NUMBER.matches(value.content)) -> value.content
        value is JsonNode.Array && operator == TestFormat.IN -> value.items.joinToString(",", "[", "]") { written(it, "") }
        else -> throw IllegalArgumentException(
            "the value is ${value.words}; expected a number or text with a Jason term, as in \"front\" or \"\\\"a string\\\"\"",
        )
    }

    private fun deadband(member: JsonNode.Member, index: Int?): Deadband? {
        val value = member.value
        val width = (value as? JsonNode.Scalar)?.takeUnless { it.isText }?.content?.toDoubleOrNull()
        if (width != null && width > 0 && width.isFinite()) return Deadband(index, width)
        report(value.position, "the deadband is ${value.words}; expected a number above 0, by which the argument must move")
        return null
    }

    private fun wholeNumber(member: JsonNode.Member?, least: Long, most: Long = Int.MAX_VALUE.toLong()): Long? {
        val value = member?.value ?: return null
        val number = (value as? JsonNode.Scalar)?.takeUnless { it.isText }?.content?.toLongOrNull()?.takeIf { it in least..most }
        if (number == null) report(value.position, "\"${member.name}\" is ${value.words}; expected a whole number from $least")
        return number
    }

    private fun text(member: JsonNode.Member): String? {
        val value = member.value
        if (value is JsonNode.Scalar && value.isText) return value.content
        report(value.position, "\"${member.name}\" is ${value.words}; expected text")
        return null
    }

    private fun items(member: JsonNode.Member?): List<JsonNode> {
        val value = member?.value ?: return emptyList()
        if (value !is JsonNode.Array) report(value.position, "\"${member.name}\" is ${value.words}; expected an array")
        return (value as? JsonNode.Array)?.items.orEmpty()
    }

    /** The members of [node] by name; those that are not [known] and those that come twice are reported. Null if it is no object. */
    private fun members(node: JsonNode, what: String, vararg known: String): Map<String, JsonNode.Member>? {
        if (node !is JsonNode.Object) {
            report(node.position, "${node.words} where $what is expected, an object with ${known.joinToString(" or ")}")
            return null
        }
        val members = LinkedHashMap<String, JsonNode.Member>()
        for (member in node.members) {
            if (member.name !in known) report(member.position, "\"${member.name}\" in $what; expected ${known.joinToString(" or ")}")
            if (members.put(member.name, member) != null) report(member.position, "a second \"${member.name}\" in $what; expected one")
        }
        return members
    }

    private fun refuse(members: Map<String, JsonNode.Member>, name: String, what: String) {
        members[name]?.let { report(it.position, "\"$name\" on $what, which has none") }
    }

    private fun <T> reporting(node: JsonNode, read: () -> T): T? = problems.reporting(node.position, read = read)

    private fun report(at: Position, message: String) = problems.report(at, message)

    private companion object {
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
        val NUMBER = Regex("-?\\d.*")
    }
}
