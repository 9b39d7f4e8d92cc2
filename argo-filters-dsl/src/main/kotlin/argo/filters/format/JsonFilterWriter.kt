package argo.filters.format

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.GroundTerm
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.TermTest
import com.fasterxml.jackson.core.JsonFactory
import com.fasterxml.jackson.core.JsonGenerator
import com.fasterxml.jackson.core.util.DefaultIndenter
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter
import com.fasterxml.jackson.core.util.Separators
import java.io.StringWriter

/** Writes filters in the canonical form of the JSON format. */
internal class JsonFilterWriter {
    private val text = StringWriter()
    private val json: JsonGenerator = JsonFactory().createGenerator(text).setPrettyPrinter(printer())

    fun write(filter: PerceptionFilter): String {
        json.use { filter(filter) }
        return "$text\n"
    }

    private fun filter(filter: PerceptionFilter) = entity {
        if (filter.mode == PerceptionFilter.Mode.KEEP) json.writeBooleanField("keep", true)
        if (filter.onSwitch == PerceptionFilter.OnSwitch.FREEZE) json.writeStringField("onSwitch", "freeze")
        if (filter.critical.isNotEmpty()) array("critical", filter.critical, ::criticalRule)
        array("rules", filter.rules, ::rule)
    }

    private fun rule(rule: Rule) = entity {
        json.writeStringField("predicate", rule.predicate.toString())
        rule.arity?.let { json.writeNumberField("arity", it) }
        rule.rate?.everyMs?.let { json.writeNumberField("everyMs", it) }
        val (all, some) = rule.rate?.deadbands.orEmpty().partition { it.argument == null }
        all.forEach { numberField("deadband", it.width) }
        val conditions = rule.conditions.map { { condition(it) } } + some.map { { argumentDeadband(it.argument!!, it.width) } }
        if (conditions.isNotEmpty()) array("conditions", conditions) { it() }
    }

    private fun criticalRule(critical: CriticalRule) = entity {
        json.writeStringField("predicate", critical.rule.predicate.toString())
        critical.rule.arity?.let { json.writeNumberField("arity", it) }
        critical.reflex?.let { json.writeStringField("reflex", it) }
        if (critical.rule.conditions.isNotEmpty()) array("conditions", critical.rule.conditions, ::condition)
    }

    private fun argumentDeadband(argument: Int, width: Double) = entity {
        json.writeNumberField("argument", argument)
        numberField("deadband", width)
    }

    private fun condition(condition: Condition) = entity {
        when (condition) {
            is Condition.Argument -> {
                json.writeNumberField("argument", condition.index)
                test(condition.test)
            }
            is Condition.Annotation -> {
                json.writeStringField("annotation", condition.name.toString())
                val single = condition.tests.singleOrNull()
                if (single != null) test(single)
                else if (condition.tests.isNotEmpty()) array("limits", condition.tests) { entity { test(it) } }
            }
        }
    }

    private fun test(test: TermTest) {
        json.writeStringField("operator", TestFormat.operator(test))
        when (test) {
            is TermTest.Compare -> json.writeFieldName("value").also { value(test.value) }
            is TermTest.OneOf -> array("value", test.values, ::value)
            is TermTest.Matches -> json.writeStringField("value", test.pattern)
        }
    }

    private fun value(value: GroundTerm) =
        if (value is GroundTerm.Number && value.value.isFinite()) json.writeNumber("$value") else json.writeString("$value")

    private fun numberField(name: String, number: Double) {
        json.writeFieldName(name)
        value(GroundTerm.Number(number))
    }

    private fun entity(members: () -> Unit) {
        json.writeStartObject()
        members()
        json.writeEndObject()
    }

    private fun <T> array(name: String, items: Collection<T>, item: (T) -> Unit) {
        json.writeArrayFieldStart(name)
        items.forEach(item)
        json.writeEndArray()
    }

    private fun printer(): DefaultPrettyPrinter {
        val lines = DefaultIndenter("  ", "\n")
        val separators = Separators.createDefaultInstance()
            .withObjectFieldValueSpacing(Separators.Spacing.AFTER)
            .withArrayEmptySeparator("")
        return DefaultPrettyPrinter(separators).apply {
            indentArraysWith(lines)
            indentObjectsWith(lines)
        }
    }
}
