package argo.filters.format

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.Deadband
import argo.filters.FilterException
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.TermTest

/** Makes a filter of an XML document, or a list of all that is wrong with it. */
internal class XmlFilterReader(text: String, source: String, private val name: String) {
    private val tree = XmlTreeReader(text, source).read()
    private val problems = Problems(source)

    /** @throws FilterException with all problems of the document, in the order of the text */
    fun read(): PerceptionFilter {
        val filter = tree.root?.let(::filter)
        tree.problem?.let(problems::report)
        return problems.unlessAny(filter)
    }

    private fun filter(root: XmlElement): PerceptionFilter? {
        if (root.name != ROOT) {
            report(root.position, "the root element is <${root.name}>; expected <$ROOT>")
            if (!root.name.equals(ROOT, ignoreCase = true)) return null
        }
        val attributes = attributes(root, KEEP, ON_SWITCH)
        noText(root)
        val mode = oneOf(attributes[KEEP], FilterWords.MODES) ?: PerceptionFilter.Mode.DROP
        val onSwitch = oneOf(attributes[ON_SWITCH], FilterWords.ON_SWITCHES) ?: PerceptionFilter.OnSwitch.FORGET
        val (rules, critical) = children(root, FILTER, CRITICAL).partition { it.name == FILTER }
        return PerceptionFilter(name, rules.mapNotNull(::rule), mode, onSwitch, critical.mapNotNull(::criticalRule))
    }

    private fun <T> oneOf(attribute: XmlAttribute?, words: Map<String, T>): T? {
        if (attribute == null) return null
        val found = words[attribute.value.trim()]
        if (found == null) reportValue(attribute, words.keys.joinToString(" or "))
        return found
    }

    private fun rule(element: XmlElement): Rule? {
        val attributes = attributes(element, ARITY, EVERY_MS, DEADBAND)
        val rate = rate(attributes, element.children.filter { it.name == PARAMETER })
        return rule(element, attributes)?.copy(rate = rate)
    }

    private fun criticalRule(element: XmlElement): CriticalRule? {
        val attributes = attributes(element, ARITY, REFLEX)
        val deadbands = element.children.filter { it.name == PARAMETER }.flatMap { it.attributes }.filter { it.name == DEADBAND }
        deadbands.forEach { report(it.position, "a deadband in <$CRITICAL>; a critical percept is never held back") }
        val reflex = attributes[REFLEX]
        val command = reflex?.let { problems.reporting(it.position) { it.value.also(CriticalRule::requireSendable) } }
        val rule = rule(element, attributes)
        return if (rule == null || reflex != null && command == null) null else CriticalRule(rule, command)
    }

    /** The rule that [element] is, without a rate. */
    private fun rule(element: XmlElement, attributes: Map<String, XmlAttribute>): Rule? {
        noText(element)
        val children = children(element, PREDICATE, PARAMETER, *ANNOTATION)
        val predicate = predicate(element, children.filter { it.name == PREDICATE })
        val conditions = children.mapNotNull {
            when (it.name) {
                PREDICATE -> null
                PARAMETER -> argument(it)
                else -> annotation(it)
            }
        }
        val arity = wholeNumber(attributes[ARITY], 0..Int.MAX_VALUE.toLong())?.toInt()
        return predicate?.let { Rule(it, conditions, arity) }
    }

    private fun rate(rule: Map<String, XmlAttribute>, parameters: List<XmlElement>): Rate? {
        val everyMs = wholeNumber(rule[EVERY_MS], 1..Long.MAX_VALUE)
        val deadbands = LinkedHashMap<Int?, Deadband>()
        rule[DEADBAND]?.let { deadband(it, null) }?.let { deadbands[null] = it }
        for (parameter in parameters) {
            val attribute = parameter.attributes.find { it.name == DEADBAND } ?: continue
            val index = parameter.attributes.find { it.name == ID }?.let { indexOf(it.value) } ?: continue
            if (index in deadbands) report(attribute.position, "a second deadband for the argument $index; expected one")
            deadband(attribute, index)?.let { deadbands[index] = it }
        }
        return if (everyMs == null && deadbands.isEmpty()) null else Rate(everyMs, deadbands.values.toSet())
    }

    private fun deadband(attribute: XmlAttribute, index: Int?): Deadband? {
        val width = GroundTerm.ofOrNull(attribute.value) as? GroundTerm.Number
        if (width != null && width.value > 0 && width.value.isFinite()) return Deadband(index, width.value)
        report(attribute.position, "the deadband '${attribute.value}'; expected a number above 0, by which the argument must move")
        return null
    }

    private fun wholeNumber(attribute: XmlAttribute?, range: LongRange): Long? {
        if (attribute == null) return null
        val number = wholeNumber(attribute.value)?.takeIf { it in range }
        if (number == null) reportValue(attribute, "a whole number from ${range.first}")
        return number
    }

    private fun reportValue(attribute: XmlAttribute, expected: String) =
        report(attribute.position, "${attribute.name}=\"${attribute.value}\"; expected $expected")

    private fun predicate(rule: XmlElement, found: List<XmlElement>): Predicate? {
        if (found.isEmpty()) {
            if (isWhole(rule)) report(rule.position, "the rule has no predicate; expected one, as in <predicate>dist</predicate>")
            return null
        }
        found.drop(1).forEach { report(it.position, "a second predicate in one rule; expected one, and another <filter> for the other") }
        return found.map(::predicate).first()
    }

    private fun predicate(element: XmlElement): Predicate? {
        attributes(element)
        children(element)
        return predicate(element.text, element.textPosition, "predicate", isWhole(element))
    }

    private fun predicate(text: String, at: Position, what: String, isWhole: Boolean = true): Predicate? {
        if (text.isEmpty()) {
            if (isWhole) report(at, "the $what is empty; expected a functor, as in dist or ~open")
            return null
        }
        return problems.reporting(at, "as the $what, the functor alone is expected") { Predicate.of(text) }
    }

    private fun argument(element: XmlElement): Condition? {
        val attributes = attributes(element, ID, OPERATOR, DEADBAND)
        children(element)
        val index = index(element, attributes[ID])
        if (DEADBAND in attributes && OPERATOR !in attributes && element.text.isEmpty()) return null
        val test = test(element, operator(attributes[OPERATOR]))
        return if (index == null || test == null) null else Condition.Argument(index, test)
    }

    private fun index(element: XmlElement, id: XmlAttribute?): Int? {
        if (id == null) {
            report(element.position, "the <$PARAMETER> has no id; expected id=\"0\" for the first argument, id=\"1\" for the second")
            return null
        }
        val index = indexOf(id.value)
        if (index == null) report(id.position, "the id '${id.value}'; expected a whole number from 0, the number of the argument")
        return index
    }

    private fun indexOf(written: String): Int? = wholeNumber(written)?.takeIf { it <= Int.MAX_VALUE }?.toInt()

    private fun wholeNumber(written: String): Long? =
        written.trim().takeIf { it.isNotEmpty() && it.all { digit -> digit in '0'..'9' } }?.toLongOrNull()

    private fun annotation(element: XmlElement): Condition? {
        val attributes = attributes(element, NAME, OPERATOR)
        val limits = children(element, LIMIT)
        val name = annotationName(element, attributes[NAME])
        val ownOperator = attributes[OPERATOR]
        val tests = when {
            limits.isNotEmpty() -> limits(element, limits, ownOperator)
            ownOperator == null && element.text.isEmpty() -> emptyList()
            else -> listOf(test(element, operator(ownOperator)))
        }
        return if (name == null || null in tests) null else Condition.Annotation(name, tests.filterNotNull())
    }

    private fun annotationName(element: XmlElement, name: XmlAttribute?): Predicate? {
        if (name != null) return predicate(name.value.trim(), name.position, "annotation's name")
        report(element.position, "the <${element.name}> has no name; expected the annotation's functor, as in name=\"q\"")
        return null
    }

    private fun limits(annotation: XmlElement, limits: List<XmlElement>, inherited: XmlAttribute?): List<TermTest?> {
        noText(annotation)
        val usual = operator(inherited)
        return limits.map {
            val own = attributes(it, OPERATOR)[OPERATOR]
            children(it)
            if (own != null && inherited != null) {
                report(own.position, "a second operator for one annotation; expected it on <$LIMIT> or around it")
            }
            test(it, if (own == null) usual else operator(own))
        }
    }

    private fun test(element: XmlElement, operator: String?): TermTest? {
        val text = element.text
        if (text.isEmpty()) {
            if (isWhole(element)) report(element.position, "the <${element.name}> is empty; expected the value to compare with")
            return null
        }
        return operator?.let { problems.reporting(element.textPosition) { TestFormat.test(it, text) } }
    }

    private fun operator(attribute: XmlAttribute?): String? {
        if (attribute == null) return Operator.EQ.name
        val operator = TestFormat.operator(attribute.value)
        if (operator == null) report(attribute.position, "the operator '${attribute.value}'; expected ${TestFormat.NAMES}")
        return operator
    }

    /** The attributes of [element] by name; those that are not [known] are reported. */
    private fun attributes(element: XmlElement, vararg known: String): Map<String, XmlAttribute> {
        val (expected, unknown) = element.attributes.partition { it.name in known }
        unknown.forEach { report(it.position, "the attribute '${it.name}' on <${element.name}>; expected ${words(known, "no attribute")}") }
        expected.groupBy(XmlAttribute::name).values.flatMap { it.drop(1) }.forEach {
            report(it.position, "a second '${it.name}' on <${element.name}>; expected one")
        }
        return expected.associateBy(XmlAttribute::name)
    }

    /** The children of [element] that are [known]; others are reported. */
    private fun children(element: XmlElement, vararg known: String): List<XmlElement> {
        val (expected, unknown) = element.children.partition { it.name in known }
        val elements = words(known.map { "<$it>" }.toTypedArray(), "text alone")
        unknown.forEach { report(it.position, "the element <${it.name}> in <${element.name}>; expected $elements") }
        return expected
    }

    private fun words(known: Array<out String>, none: String) = if (known.isEmpty()) none else known.joinToString(" or ")

    private fun noText(element: XmlElement) = element.texts.filter { it.text.isNotBlank() }.forEach {
        report(it.position, "the text '${it.text.trim()}' in <${element.name}>; expected elements alone")
    }

    /** What is missing in an element that the document breaks off in is no problem of its own. */
    private fun isWhole(element: XmlElement) = element.isClosed || tree.problem == null

    private fun report(at: Position, message: String) = problems.report(at, message)

    private companion object {
        const val ROOT = "PerceptionFilter"
        const val FILTER = "filter"
        const val CRITICAL = "critical"
        const val REFLEX = "reflex"
        const val PREDICATE = "predicate"
        const val PARAMETER = "parameter"
        const val LIMIT = "limit"
        const val KEEP = "keep"
        const val ON_SWITCH = "onSwitch"
        const val ARITY = "arity"
        const val EVERY_MS = "everyMs"
        const val DEADBAND = "deadband"
        const val ID = "id"
        const val NAME = "name"
        const val OPERATOR = "operator"

        /** The second is how files of earlier versions spell it. */
        val ANNOTATION = arrayOf("annotation", "anotation")
    }
}
