package argo.filters.format

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.Deadband
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.Test
import argo.filters.Value
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArrayBuilder
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.JsonUnquotedLiteral
import kotlinx.serialization.json.buildJsonArray
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray

/** Writes filters in the canonical form of the JSON format. */
internal object JsonFilterWriter {
    @OptIn(ExperimentalSerializationApi::class)
    private val JSON = Json {
        prettyPrint = true
        prettyPrintIndent = "  "
    }

    fun write(filter: PerceptionFilter): String = JSON.encodeToString(JsonElement.serializer(), filter(filter)) + "\n"

    private fun filter(filter: PerceptionFilter): JsonObject = buildJsonObject {
        if (filter.mode == PerceptionFilter.Mode.KEEP) put("keep", true)
        if (filter.onSwitch == PerceptionFilter.OnSwitch.FREEZE) put("onSwitch", "freeze")
        if (filter.critical.isNotEmpty()) putJsonArray("critical") { filter.critical.forEach { add(criticalRule(it)) } }
        putJsonArray("rules") { filter.rules.forEach { add(rule(it)) } }
    }

    private fun rule(rule: Rule): JsonObject = buildJsonObject {
        put("predicate", rule.predicate.toString())
        rule.arity?.let { put("arity", it) }
        rule.rate?.everyMs?.let { put("everyMs", it) }
        val (all, some) = rule.rate?.deadbands.orEmpty().partition { it.argument == null }
        all.forEach { put("deadband", number(it.width)) }
        if (rule.conditions.isNotEmpty() || some.isNotEmpty()) {
            putJsonArray("conditions") {
                rule.conditions.forEach { add(condition(it)) }
                some.forEach { add(deadband(it)) }
            }
        }
    }

    private fun criticalRule(critical: CriticalRule): JsonObject = buildJsonObject {
        put("predicate", critical.rule.predicate.toString())
        critical.rule.arity?.let { put("arity", it) }
        critical.reflex?.let { put("reflex", it) }
        if (critical.rule.conditions.isNotEmpty()) putJsonArray("conditions") { critical.rule.conditions.forEach { add(condition(it)) } }
    }

    private fun deadband(deadband: Deadband) = buildJsonObject {
        put("argument", deadband.argument)
        put("deadband", number(deadband.width))
    }

    private fun condition(condition: Condition): JsonObject = buildJsonObject {
        when (condition) {
            is Condition.Argument -> {
                put("argument", condition.index)
                test(condition.test)
            }
            is Condition.Annotation -> {
                put("annotation", condition.name.toString())
                val single = condition.tests.singleOrNull()
                if (single != null) test(single) else if (condition.tests.isNotEmpty()) limits(condition.tests)
            }
        }
    }

    private fun JsonObjectBuilder.limits(tests: List<Test>) = putJsonArray("limits") { tests.forEach { limit(it) } }

    private fun JsonArrayBuilder.limit(test: Test) = add(buildJsonObject { test(test) })

    private fun JsonObjectBuilder.test(test: Test) {
        put("operator", TestFormat.operator(test))
        put("value", value(test))
    }

    private fun value(test: Test): JsonElement = when (test) {
        is Test.Compare -> value(test.value)
        is Test.OneOf -> buildJsonArray { test.values.forEach { add(value(it)) } }
        is Test.Matches -> JsonPrimitive(test.pattern)
    }

    private fun value(value: Value): JsonElement =
        if (value is Value.Number && value.value.isFinite()) number(value.value) else JsonPrimitive(value.toString())

    @OptIn(ExperimentalSerializationApi::class)
    private fun number(number: Double): JsonElement = JsonUnquotedLiteral(Value.Number(number).toString())
}
