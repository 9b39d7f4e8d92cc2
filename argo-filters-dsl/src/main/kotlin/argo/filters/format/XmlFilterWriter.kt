package argo.filters.format

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.Deadband
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.Test
import argo.filters.Value
import nl.adaptivity.xmlutil.XmlDeclMode
import nl.adaptivity.xmlutil.XmlWriter
import nl.adaptivity.xmlutil.core.XmlVersion
import nl.adaptivity.xmlutil.newWriter
import nl.adaptivity.xmlutil.xmlStreaming

/** Writes filters in the canonical form of the XML format: operators spelt out, parts of a rule in the order of the model. */
internal class XmlFilterWriter {
    private val text = StringBuilder()
    private val xml: XmlWriter = xmlStreaming.newWriter(text, false, XmlDeclMode.None, XmlVersion.XML10)

    fun write(filter: PerceptionFilter): String {
        xml.indentString = "  "
        element("PerceptionFilter") {
            if (filter.mode == PerceptionFilter.Mode.KEEP) attribute("keep", "true")
            if (filter.onSwitch == PerceptionFilter.OnSwitch.FREEZE) attribute("onSwitch", "freeze")
            filter.critical.forEach(::criticalRule)
            filter.rules.forEach(::rule)
        }
        xml.close()
        return "<?xml version=\"1.0\"?>\n" + text.trim() + "\n"
    }

    private fun rule(rule: Rule) = element("filter") {
        rule.arity?.let { attribute("arity", it.toString()) }
        rule.rate?.everyMs?.let { attribute("everyMs", it.toString()) }
        val (all, some) = rule.rate?.deadbands.orEmpty().partition { it.argument == null }
        all.forEach { attribute("deadband", Value.Number(it.width).toString()) }
        element("predicate") { text(rule.predicate.toString()) }
        rule.conditions.forEach(::condition)
        some.forEach(::deadband)
    }

    private fun criticalRule(critical: CriticalRule) = element("critical") {
        critical.rule.arity?.let { attribute("arity", it.toString()) }
        critical.reflex?.let { attribute("reflex", it) }
        element("predicate") { text(critical.rule.predicate.toString()) }
        critical.rule.conditions.forEach(::condition)
    }

    private fun deadband(deadband: Deadband) = element("parameter") {
        attribute("id", deadband.argument.toString())
        attribute("deadband", Value.Number(deadband.width).toString())
    }

    private fun condition(condition: Condition) = when (condition) {
        is Condition.Argument -> element("parameter") {
            test(condition.test) { attribute("id", condition.index.toString()) }
        }
        is Condition.Annotation -> element("annotation") { annotation(condition) }
    }

    private fun annotation(condition: Condition.Annotation) {
        attribute("name", condition.name.toString())
        val single = condition.tests.singleOrNull()
        if (single != null) test(single) else condition.tests.forEach { element("limit") { test(it) } }
    }

    private fun test(test: Test, otherAttributes: () -> Unit = {}) {
        attribute("operator", TestFormat.operator(test))
        otherAttributes()
        text(TestFormat.value(test))
    }

    private fun attribute(name: String, value: String) = xml.attribute(null, name, null, requireXml(value))

    /** Carriage returns need a character reference, since a parser reads a bare one as a line feed. */
    private fun text(text: String) = requireXml(text).split('\r').forEachIndexed { number, part ->
        if (number > 0) xml.entityRef("#13")
        if (part.isNotEmpty()) xml.text(part)
    }

    private fun requireXml(text: String): String {
        val foreign = text.codePoints().filter { !isXml(it) }.findFirst()
        require(foreign.isEmpty) { "XML cannot hold the character U+%04X, which stands in %s".format(foreign.asInt, text) }
        return text
    }

    private fun isXml(character: Int) = when (character) {
        '\t'.code, '\n'.code, '\r'.code -> true
        else -> character in 0x20..0xD7FF || character in 0xE000..0xFFFD || character in 0x10000..0x10FFFF
    }

    private fun element(name: String, content: () -> Unit) {
        xml.startTag("", name, "")
        content()
        xml.endTag("", name, "")
    }
}
