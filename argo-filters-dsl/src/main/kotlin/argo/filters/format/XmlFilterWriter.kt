package argo.filters.format

import argo.filters.Condition
import argo.filters.GroundTerm
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.SmoothingRule
import argo.filters.TermTest

/** Writes filters in the canonical XML form. This form has every operator, and a rule's parts in the order of [Rule]. */
internal class XmlFilterWriter {
    private val text = StringBuilder("<?xml version=\"1.0\"?>\n")
    private var depth = 0

    fun write(filter: PerceptionFilter): String {
        val keep = if (filter.mode == PerceptionFilter.Mode.KEEP) "true" else null
        val onSwitch = if (filter.onSwitch == PerceptionFilter.OnSwitch.FREEZE) "freeze" else null
        val isEmpty = filter.smoothing.isEmpty() && filter.critical.isEmpty() && filter.rules.isEmpty()
        element("PerceptionFilter", "keep" to keep, "onSwitch" to onSwitch, isEmpty = isEmpty) {
            filter.smoothing.forEach(::smoothing)
            filter.critical.forEach { rule("critical", it.rule, "smoothed" to it.smoothed.orNull(), "reflex" to it.reflex) }
            filter.rules.forEach { rule("filter", it) }
        }
        return text.toString()
    }

    private fun rule(name: String, rule: Rule, vararg own: Pair<String, Any?>, more: () -> Unit = {}) {
        val (all, some) = rule.rate?.deadbands.orEmpty().partition { it.argument == null }
        val deadband = all.firstOrNull()?.let { number(it.width) }
        element(name, "arity" to rule.arity, *own, "everyMs" to rule.rate?.everyMs, "deadband" to deadband) {
            leaf("predicate", rule.predicate.toString())
            rule.conditions.forEach(::condition)
            some.forEach { leaf("parameter", "", "id" to it.argument, "deadband" to number(it.width)) }
            more()
        }
    }

    private fun smoothing(smoothing: SmoothingRule) = rule("smooth", smoothing.rule, "annotate" to smoothing.annotates.orNull()) {
        leaf(
            "parameter", "", "id" to smoothing.argument, "maxRate" to smoothing.maxRate?.let(::number),
            "outliers" to smoothing.outliers?.let { number(it.deviations) }, "among" to smoothing.outliers?.among,
            "median" to smoothing.median,
        )
    }

    private fun Boolean.orNull() = takeIf { it }

    private fun number(number: Double) = GroundTerm.Number(number).toString()

    private fun condition(condition: Condition) = when (condition) {
        is Condition.Argument -> test("parameter", condition.test, "until" to condition.until?.let(::number), "id" to condition.index)
        is Condition.Annotation -> annotation(condition)
    }

    private fun annotation(condition: Condition.Annotation) {
        val name = "name" to condition.name
        when (condition.tests.size) {
            0 -> leaf("annotation", "", name)
            1 -> condition.tests.single().let {
                leaf("annotation", OperatorFormat.value(it), name, "operator" to OperatorFormat.operator(it))
            }
            else -> element("annotation", name) { condition.tests.forEach { test("limit", it) } }
        }
    }

    private fun test(name: String, test: TermTest, vararg attributes: Pair<String, Any?>) =
        leaf(name, OperatorFormat.value(test), "operator" to OperatorFormat.operator(test), *attributes)

    private fun element(name: String, vararg attributes: Pair<String, Any?>, isEmpty: Boolean = false, children: () -> Unit) {
        if (isEmpty) return leaf(name, "", *attributes)
        line("<$name${written(attributes)}>")
        depth++
        children()
        depth--
        line("</$name>")
    }

    private fun leaf(name: String, content: String, vararg attributes: Pair<String, Any?>) =
        line("<$name${written(attributes)}" + if (content.isEmpty()) "/>" else ">${escaped(content, "\r")}</$name>")

    private fun written(attributes: Array<out Pair<String, Any?>>) =
        attributes.filter { it.second != null }.joinToString("") { (name, value) -> " $name=\"${escaped("$value", "\t\n\r\"")}\"" }

    private fun line(line: String) {
        text.append("  ".repeat(depth)).append(line).append('\n')
    }

    /**
     * Returns [text] with character references for markup and for the characters in [unsafe]. A parser would change the unsafe
     * characters.
     */
    private fun escaped(text: String, unsafe: String): String {
        val foreign = text.codePoints().filter { !isXml(it) }.findFirst()
        require(foreign.isEmpty) { "XML cannot hold the character U+%04X, which stands in %s".format(foreign.asInt, text) }
        return text.toCharArray().joinToString("") { ENTITIES[it] ?: if (it in unsafe) "&#${it.code};" else "$it" }
    }

    private fun isXml(character: Int) = when (character) {
        '\t'.code, '\n'.code, '\r'.code -> true
        else -> character in 0x20..0xD7FF || character in 0xE000..0xFFFD || character in 0x10000..0x10FFFF
    }

    private companion object {
        val ENTITIES = mapOf('&' to "&amp;", '<' to "&lt;", '>' to "&gt;")
    }
}
