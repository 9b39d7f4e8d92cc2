package argo.filters.format

import argo.filters.format.FilterNode.Member
import argo.filters.format.FilterNode.Scalar

/** Converts an XML document into the tree for [FilterReader]. Reports wrong elements and attributes to [problems]. */
internal class XmlFilterTree(private val tree: XmlTree, private val problems: Problems) {

    fun filter(): FilterNode? {
        tree.problem?.let(problems::report)
        val root = tree.root ?: return null
        if (root.name != ROOT) {
            report(root.position, "the root element is <${root.name}>; expected <$ROOT>")
            if (!root.name.equals(ROOT, ignoreCase = true)) return null
        }
        noText(root)
        val attributes = attributes(root, FilterReader.KEEP, FilterReader.ON_SWITCH).values
        val rules = children(root, FILTER, FilterReader.CRITICAL, FilterReader.SMOOTH).groupBy { it.name }
        val arrays = RULES.map { (name, kind) -> array(root, kind.member, rules[name].orEmpty()) { rule(it, kind) } }
        return FilterNode.Object(root.position, attributes + arrays)
    }

    private fun rule(element: XmlElement, kind: RuleKind): FilterNode {
        noText(element)
        val attributes = attributes(element, *kind.attributes).values
        val (predicates, conditions) =
            children(element, FilterReader.PREDICATE, PARAMETER, *ANNOTATION).partition { it.name == FilterReader.PREDICATE }
        predicates.drop(1).forEach {
            report(it.position, "a second predicate in one rule; expected one, and another <filter> for the other")
        }
        val predicate = Member(
            FilterReader.PREDICATE, element.position,
            predicates.map(::predicate).firstOrNull()
                ?: missing(element, "the rule has no predicate; expected one, as in <predicate>dist</predicate>"),
        )
        val array = array(element, FilterReader.CONDITIONS, conditions) { if (it.name == PARAMETER) argument(it, kind) else annotation(it) }
        return FilterNode.Object(element.position, attributes + predicate + array)
    }

    private fun predicate(element: XmlElement): FilterNode {
        attributes(element)
        children(element)
        return text(element, "the predicate is empty; expected a functor, as in dist or ~open")
    }

    private fun argument(element: XmlElement, kind: RuleKind): FilterNode {
        val attributes = attributes(element, ID, FilterReader.OPERATOR, FilterReader.UNTIL, *kind.ofArguments)
        children(element)
        val id = required(element, ID, attributes, "expected id=\"0\" for the first argument, id=\"1\" for the second")
        val isCondition = kind.ofArguments.none(attributes::containsKey) || element.text.isNotEmpty() ||
            FilterReader.OPERATOR in attributes || FilterReader.UNTIL in attributes
        val value = if (isCondition) value(element) else null
        return FilterNode.Object(element.position, attributes.minus(ID).values + listOfNotNull(id, value))
    }

    private fun annotation(element: XmlElement): FilterNode {
        val attributes = attributes(element, NAME, FilterReader.OPERATOR)
        val limits = children(element, LIMIT)
        val name = required(element, NAME, attributes, "expected the annotation's functor, as in name=\"q\"")
        val operator = attributes[FilterReader.OPERATOR]
        if (limits.isNotEmpty()) noText(element)
        val tests = when {
            limits.isNotEmpty() -> listOf(array(element, FilterReader.LIMITS, limits) { limit(it, operator) })
            operator == null && element.text.isEmpty() -> emptyList()
            else -> listOfNotNull(operator, value(element))
        }
        return FilterNode.Object(element.position, tests + name)
    }

    /** Reads a limit. A limit without an operator gets the operator of the element [around] it. */
    private fun limit(element: XmlElement, around: Member?): FilterNode {
        val own = attributes(element, FilterReader.OPERATOR)[FilterReader.OPERATOR]
        children(element)
        if (own != null && around != null) {
            report(own.position, "a second operator for one annotation; expected it on <$LIMIT> or around it")
        }
        return FilterNode.Object(element.position, listOfNotNull(own ?: around, value(element)))
    }

    private fun value(element: XmlElement): Member {
        val value = text(element, "the <${element.name}> is empty; expected the value to compare with")
        return Member(FilterReader.VALUE, element.position, value)
    }

    private fun text(element: XmlElement, empty: String): FilterNode =
        if (element.text.isEmpty()) missing(element, empty)
        else Scalar(element.textPosition, element.text, isText = true, isBare = true)

    private fun array(parent: XmlElement, name: String, elements: List<XmlElement>, item: (XmlElement) -> FilterNode) =
        Member(name, parent.position, FilterNode.Array(parent.position, elements.map(item)))

    private fun required(element: XmlElement, name: String, attributes: Map<String, Member>, expected: String): Member {
        attributes[name]?.let { return it }
        report(element.position, "the <${element.name}> has no $name; $expected")
        return Member(MEMBER_OF.getValue(name), element.position, FilterNode.Refused(element.position))
    }

    /** Reports [problem]. If the document breaks off in [element], the break is the cause, so reports nothing. */
    private fun missing(element: XmlElement, problem: String): FilterNode {
        if (element.isClosed || tree.problem == null) report(element.position, problem)
        return FilterNode.Refused(element.position)
    }

    private fun attributes(element: XmlElement, vararg known: String): Map<String, Member> {
        val members = LinkedHashMap<String, Member>()
        for (attribute in element.attributes) {
            val (name, at) = attribute.name to attribute.position
            if (name !in known) report(at, "the attribute '$name' on <${element.name}>; expected ${words(known, "no attribute")}")
            else if (members.put(name, member(attribute)) != null) report(at, "a second '$name' on <${element.name}>; expected one")
        }
        return members
    }

    private fun member(attribute: XmlAttribute): Member {
        val (name, text) = attribute.name to attribute.value
        val words = if (name == ID || name in NUMBERS) "the $name '$text'" else "$name=\"$text\""
        return Member(MEMBER_OF[name] ?: name, attribute.position, Scalar(attribute.position, text, isText = true, isBare = true), words)
    }

    private fun children(element: XmlElement, vararg known: String): List<XmlElement> {
        val (expected, unknown) = element.children.partition { it.name in known }
        val elements = words(known.map { "<$it>" }.toTypedArray(), "only text")
        unknown.forEach { report(it.position, "the element <${it.name}> in <${element.name}>; expected $elements") }
        return expected
    }

    private fun words(known: Array<out String>, none: String) = if (known.isEmpty()) none else known.joinToString(" or ")

    private fun noText(element: XmlElement) = element.texts.filter { it.text.isNotBlank() }.forEach {
        report(it.position, "the text '${it.text.trim()}' in <${element.name}>; expected only elements")
    }

    private fun report(at: Position, message: String) = problems.report(at, message)

    /**
     * A kind of rules.
     *
     * @param member the member of the filter that has these rules
     * @param attributes the attributes that a rule may have
     * @param ofArguments further attributes that the rule's parameters may have
     */
    private class RuleKind(val member: String, val attributes: Array<String>, val ofArguments: Array<String>)

    private companion object {
        const val ROOT = "PerceptionFilter"
        const val FILTER = "filter"
        const val PARAMETER = "parameter"
        const val LIMIT = "limit"
        const val ID = "id"
        const val NAME = "name"

        /** The kinds of rules by the names of their elements. */
        val RULES = mapOf(
            FILTER to RuleKind(
                FilterReader.RULES, arrayOf(FilterReader.ARITY, FilterReader.EVERY_MS, FilterReader.DEADBAND),
                arrayOf(FilterReader.DEADBAND),
            ),
            FilterReader.CRITICAL to RuleKind(
                FilterReader.CRITICAL, arrayOf(FilterReader.ARITY, FilterReader.REFLEX, FilterReader.SMOOTHED),
                arrayOf(FilterReader.DEADBAND),
            ),
            FilterReader.SMOOTH to RuleKind(
                FilterReader.SMOOTH, arrayOf(FilterReader.ARITY, FilterReader.ANNOTATE), FilterReader.SMOOTHING.toTypedArray(),
            ),
        )

        /** Attributes whose values are numbers. */
        val NUMBERS = FilterReader.SMOOTHING + FilterReader.DEADBAND + FilterReader.UNTIL

        /** Maps attributes to members of the tree with other names. */
        val MEMBER_OF = mapOf(ID to FilterReader.ARGUMENT, NAME to FilterReader.ANNOTATION)

        /** The second spelling is that of earlier files. [XmlTree] handles other differences of earlier files. */
        val ANNOTATION = arrayOf("annotation", "anotation")
    }
}
