package argo.ros.bridge

import argo.filters.Problem
import argo.ros.mapping.CommandRule
import argo.ros.mapping.CommandRule.Kind
import argo.ros.mapping.Expression
import argo.ros.mapping.FieldValue
import argo.ros.mapping.Mapping
import argo.ros.mapping.MappingException
import argo.ros.mapping.MessageScope
import argo.ros.mapping.MessageType
import argo.ros.mapping.PerceptRule
import argo.ros.mapping.Place
import argo.ros.mapping.Scope
import argo.ros.mapping.Unfit
import argo.ros.mapping.UsualType
import argo.ros.mapping.Value
import argo.ros.mapping.asJson
import argo.ros.mapping.fields
import argo.ros.mapping.isRos2Action
import argo.ros.mapping.literals
import argo.ros.mapping.meantAsField
import kotlinx.serialization.json.JsonObject
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * The types of the robot's topics, services and actions, from `rosapi`. Checks a mapping against these types. Safe for use by several
 * threads.
 *
 * @param warn takes reasons why a topic or a command has no effect
 * @param tell takes the reason why the mapping cannot be checked
 */
internal class RobotTypes(
    private val mapping: Mapping,
    private val api: RosApi,
    private val warn: (String) -> Unit,
    private val tell: (String) -> Unit,
) {
    private data class Question(val service: String, val type: String)

    private val known = ConcurrentHashMap<Question, MessageType>()
    private val unknown = ConcurrentHashMap<Question, String>()
    private val missing = ArrayList<Question>() // questions that no service answers; guarded by this, like isChecked
    private var isChecked = false

    fun of(rule: PerceptRule): MessageType? = known[questionFor(rule)]

    /** Returns the type of the messages, requests or goals of [rule], or null if it is not known. */
    fun of(rule: CommandRule): MessageType? = known[questionFor(rule)]

    fun whyUnknown(rule: CommandRule): String? = unknown[questionFor(rule)]

    /** Returns the fields of [message], the answer to a command of [rule]. */
    fun scopeOfAnswer(rule: CommandRule, message: JsonObject): Scope {
        val type = known[questionForAnswer(rule)] ?: return MessageScope(message)
        return MessageScope(message, type.bytesAmong(rule.answer?.fields().orEmpty()), type.constants)
    }

    private fun questionFor(rule: PerceptRule) =
        Question(if (isRos2Action(rule.type)) "/rosapi/action_feedback_details" else MESSAGE, rule.type)

    private fun questionFor(rule: CommandRule) = when {
        rule.kind == Kind.SERVICE -> Question("/rosapi/service_request_details", rule.type)
        rule.kind == Kind.TOPIC -> Question(MESSAGE, rule.type)
        isRos2Action(rule.type) -> Question("/rosapi/action_goal_details", rule.type)
        else -> Question(MESSAGE, rule.type.removeSuffix("Action") + "Goal")
    }

    private fun questionForAnswer(rule: CommandRule) = when {
        rule.kind == Kind.SERVICE -> Question("/rosapi/service_response_details", rule.type)
        isRos2Action(rule.type) -> Question("/rosapi/action_result_details", rule.type)
        else -> Question(MESSAGE, rule.type.removeSuffix("Action") + "Result")
    }

    private val perceptRules = mapping.percepts - mapping.poses.toSet() + mapping.feedback
    private val answering = mapping.commands.filter { it.answer != null }

    /**
     * Asks for the types, and checks the fields and constants of the mapping. If a description arrives late, its type is checked at that
     * time.
     *
     * @param limitMs the wait for the descriptions, in ms
     * @throws MappingException if a field does not exist, or cannot have its value
     */
    fun check(limitMs: Long) {
        val questions =
            (perceptRules.map(::questionFor) + mapping.commands.map(::questionFor) + answering.map(::questionForAnswer)).distinct()
        val answers = questions.map { question ->
            api.ask(question.service, mapOf("type" to question.type)).handle { answer, trouble -> take(question, answer, trouble) }
        }
        try {
            CompletableFuture.allOf(*answers.toTypedArray()).get(limitMs, TimeUnit.MILLISECONDS)
        } catch (_: TimeoutException) {
            tell("the bridge has not described all types within $limitMs ms; those that it describes later are checked then")
        }
        val problems = synchronized(this) {
            isChecked = true
            if (missing.isNotEmpty()) tell(if (missing.size == questions.size && !api.isThere) NO_ROSAPI else unchecked())
            questions.flatMap(::problemsOf)
        }
        if (problems.isNotEmpty()) throw MappingException(problems)
        tellEmpty()
    }

    private fun take(question: Question, answer: RosApi.Answer?, trouble: Throwable?) = synchronized(this) {
        val type = answer?.let { MessageType.of(it.values, question.type) }
        when {
            type != null -> known[question] = type
            answer != null -> explain(question, "$UNKNOWN by rosapi")
            trouble is RosApi.NotKnown && trouble.isMissing -> missing += question
            else -> explain(question, trouble?.message.orEmpty().substringBefore("\\n")) // behind \n the bridge lists its search paths
        }
        if (isChecked) problemsOf(question).forEach { warn("$it") }
    }

    private fun unchecked() = missing.joinToString(", ") { it.type } +
        " is not checked, since this rosapi does not describe it: a request or goal that does not fit fails, or is dropped, on the robot"

    private fun explain(question: Question, reason: String) {
        val name = question.type
        when {
            UNLOADED.none { it in reason } ->
                if (reason.isNotEmpty()) warn("the bridge does not describe the type $name, which is not checked: $reason")
            perceptRules.any { questionFor(it) == question } ->
                warn("the bridge does not know the type $name, so the agent gets no percepts from its messages: $reason")
            mapping.commands.none { questionFor(it) == question } ->
                warn("the bridge does not know the type $name, so that no answer of this type comes: $reason")
            else -> {
                val isDoubtful = question.service == MESSAGE && UsualType.of(name) == null
                val hint = if (isDoubtful) "; is it a service or an action? Then that word stands before its name" else ""
                warn("the bridge does not know the type $name, so that no command with it leaves: $reason$hint")
            }
        }
        if (UNLOADED.any { it in reason }) unknown[question] = reason
    }

    private fun problemsOf(question: Question): List<Problem> {
        val type = known[question] ?: return emptyList()
        val read = perceptRules.filter { questionFor(it) == question }.flatMap { it.fields() } +
            answering.filter { questionForAnswer(it) == question }.flatMap { it.answer?.fields().orEmpty() }
        val values = mapping.commands.filter { questionFor(it) == question }.flatMap { it.fields }
        val inRead = read.mapNotNull { problem(it.place) { type.typeAt(it.path) } }
        val inCommands = values.mapNotNull { problem(it.place) { check(it, type) } }
        val meant = perceptRules.filter { questionFor(it) == question }.flatMap { it.percept.literals() }.filter { type.has(it.functor) }
        val inLiterals = meant.mapNotNull { literal ->
            literal.place?.let { Problem(mapping.source, it.line, it.column, meantAsField(literal.functor, type.name)) }
        }
        return (inRead + inCommands + inLiterals).distinct()
    }

    private fun tellEmpty() = mapping.commands.forEach { rule ->
        val type = of(rule) ?: return@forEach
        val empty = type.emptyAmong(rule.fields.map { it.steps }) + listOfNotNull(emptyRequest(rule, type))
        empty.forEach { warn("${mapping.source}: line ${rule.place.line}: $it") }
    }

    private fun emptyRequest(rule: CommandRule, type: MessageType): String? {
        val names = type.fieldNames
        if (rule.kind == Kind.TOPIC || rule.hasFields || names.isEmpty()) return null
        return "${rule.name} gives the fields of ${rule.type} no value: ${names.joinToString(", ")}; " +
            "write (${names.first()} = …), or () if all are to be 0, false or empty"
    }

    private fun check(field: FieldValue, type: MessageType) {
        val isConstant = field.value !is Expression.Compound && field.value.fields().isEmpty()
        if (isConstant) type.fit(field.steps, field.value.valueIn(NOTHING).asJson()) else type.requireNoMessage(field.steps)
    }

    private fun problem(place: Place, work: () -> Unit): Problem? = try {
        work()
        null
    } catch (unfit: Unfit) {
        Problem(mapping.source, place.line, place.column, unfit.message.orEmpty())
    }

    private companion object {
        const val MESSAGE = "/rosapi/message_details"
        const val NO_ROSAPI = "rosapi does not run beside the bridge, so types and fields are not checked: a message that does not fit " +
            "its type is dropped there without a report, and ages count from the arrival"
        val NOTHING = Scope { Value.None("there is none") }

        /** The reason for a type that `rosapi` of ROS 2 does not describe. */
        const val UNKNOWN = "it is not described"

        /** Parts of the messages of bridges that lack a type. */
        val UNLOADED = listOf("Unable to load", "Unable to import", "not a valid type string", UNKNOWN)
    }
}
