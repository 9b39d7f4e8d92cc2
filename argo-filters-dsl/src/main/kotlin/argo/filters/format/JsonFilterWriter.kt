package argo.filters.format

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.GroundTerm
import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.PerceptionFilter.OnSwitch
import argo.filters.Rule
import argo.filters.SmoothingRule
import argo.filters.TermTest
import com.fasterxml.jackson.core.JsonFactory
import com.fasterxml.jackson.core.JsonGenerator
import com.fasterxml.jackson.core.util.DefaultIndenter
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter
import com.fasterxml.jackson.core.util.Separators
import java.io.StringWriter

/** Writes filters in the canonical form of the JSON format. Leaves out members that are null. */
internal class JsonFilterWriter {
    private val text = StringWriter()
    private val json: JsonGenerator = JsonFactory().createGenerator(text).setPrettyPrinter(printer())

    fun write(filter: PerceptionFilter): String {
        json.use { value(filter(filter)) }
        return "$text\n"
    }

    private fun filter(filter: PerceptionFilter) = mapOf(
        "keep" to true.takeIf { filter.mode == Mode.KEEP },
        "onSwitch" to "freeze".takeIf { filter.onSwitch == OnSwitch.FREEZE },
        "smooth" to filter.smoothing.map(::smoothing).ifEmpty { null },
        "critical" to filter.critical.map { rule(it.rule, it) }.ifEmpty { null },
        "rules" to filter.rules.map { rule(it) },
    )

    private fun rule(rule: Rule, critical: CriticalRule? = null): Map<String, Any?> {
        val (all, some) = rule.rate?.deadbands.orEmpty().partition { it.argument == null }
        val deadbands = some.map { mapOf("argument" to it.argument, "deadband" to GroundTerm.Number(it.width)) }
        return mapOf(
            "predicate" to rule.predicate,
            "arity" to rule.arity,
            "smoothed" to critical?.smoothed?.takeIf { it },
            "reflex" to critical?.reflex,
            "everyMs" to rule.rate?.everyMs,
            "deadband" to all.firstOrNull()?.let { GroundTerm.Number(it.width) },
            "conditions" to (rule.conditions.map(::condition) + deadbands).ifEmpty { null },
        )
    }

    private fun smoothing(smoothing: SmoothingRule): Map<String, Any?> {
        val smoothed = mapOf(
            "argument" to smoothing.argument,
            "maxRate" to smoothing.maxRate?.let(GroundTerm::Number),
            "outliers" to smoothing.outliers?.let { GroundTerm.Number(it.deviations) },
            "among" to smoothing.outliers?.among,
            "median" to smoothing.median,
        )
        return mapOf(
            "predicate" to smoothing.rule.predicate,
            "arity" to smoothing.rule.arity,
            "annotate" to smoothing.annotates.takeIf { it },
            "conditions" to smoothing.rule.conditions.map(::condition) + smoothed,
        )
    }

    private fun condition(condition: Condition): Map<String, Any?> = when (condition) {
        is Condition.Argument ->
            mapOf("argument" to condition.index) + test(condition.test) + mapOf("until" to condition.until?.let(GroundTerm::Number))
        is Condition.Annotation -> mapOf("annotation" to condition.name) + when (condition.tests.size) {
            0 -> emptyMap()
            1 -> test(condition.tests.single())
            else -> mapOf("limits" to condition.tests.map(::test))
        }
    }

    private fun test(test: TermTest): Map<String, Any> {
        val value = when (test) {
            is TermTest.Compare -> test.value
            is TermTest.OneOf -> test.values
            is TermTest.Matches -> test.pattern
        }
        return mapOf("operator" to OperatorFormat.operator(test), "value" to value)
    }

    private fun value(value: Any): Unit = when {
        value is Map<*, *> -> members(value)
        value is Collection<*> -> {
            json.writeStartArray()
            value.filterNotNull().forEach(::value)
            json.writeEndArray()
        }
        value is Boolean -> json.writeBoolean(value)
        value is Number || value is GroundTerm.Number && value.value.isFinite() -> json.writeNumber("$value")
        else -> json.writeString("$value")
    }

    private fun members(members: Map<*, *>) {
        json.writeStartObject()
        for ((name, value) in members) {
            if (value == null) continue
            json.writeFieldName("$name")
            value(value)
        }
        json.writeEndObject()
    }

    private fun printer(): DefaultPrettyPrinter {
        val lines = DefaultIndenter("  ", "\n")
        val separators = Separators.createDefaultInstance()
            .withObjectFieldValueSpacing(Separators.Spacing.AFTER)
            .withArrayEmptySeparator("")
        return DefaultPrettyPrinter(separators).withArrayIndenter(lines).withObjectIndenter(lines)
    }
}
