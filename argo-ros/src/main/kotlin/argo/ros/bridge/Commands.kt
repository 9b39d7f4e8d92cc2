package argo.ros.bridge

import argo.filters.GroundTerm
import argo.filters.Predicate
import argo.filters.foreignText
import argo.links.Answer
import argo.links.SentCommand
import argo.ros.mapping.CommandRule
import argo.ros.mapping.CommandRule.Kind
import argo.ros.mapping.PerceptRule
import argo.ros.mapping.Scope
import argo.ros.mapping.Unfit
import argo.ros.mapping.Value
import argo.ros.mapping.asJson
import argo.ros.mapping.asTerm
import argo.ros.mapping.inWords
import argo.ros.mapping.isRos2Action
import argo.ros.mapping.written
import javino.ActionFailedException
import javino.ActionRefusedException
import javino.ActionUnconfirmedException
import javino.CommandReplacedException
import javino.CommandWithdrawnException
import javino.LineClock
import javino.PortException
import javino.PortGoneException
import javino.link.SendOptions
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.util.UUID
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionException
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicLong

/**
 * Sends an agent's commands and finds their outcomes. Each command is sent once at most. If the connection ends before an answer, the robot
 * may already have carried out the command. Safe for use by several threads.
 *
 * @param graph finds missing nodes for the commands
 * @param warn takes reports of parts that were left out of a command
 * @param progress takes a rule and the newest feedback of its goal, or null when the goal has ended
 */
internal class Commands(
    private val port: String,
    private val rules: List<CommandRule>,
    private val types: RobotTypes,
    private val graph: RobotGraph,
    private val clock: LineClock,
    private val send: (Outgoing) -> Unit,
    private val warn: (String) -> Unit,
    private val progress: (PerceptRule, JsonObject?) -> Unit,
) {
    private class Pending(val rule: CommandRule, val text: String, val message: Outgoing, val outcome: CompletableFuture<Answer>)

    private val pending = ConcurrentHashMap<String, Pending>()
    private val progressing = ConcurrentHashMap<CommandRule, Pending>() // for each rule, the goal with the newest feedback
    private val session = "argo-${UUID.randomUUID()}" // the unique prefix of this client's command ids
    private val number = AtomicLong()

    /** Returns the first messages to the bridge. The messages advertise the topics of commands, and subscribe to results. */
    fun announcements(): List<String> = rules.flatMap { rule ->
        when {
            rule.kind == Kind.TOPIC -> listOf(advertisement(rule.target, rule.type))
            rule.kind == Kind.ACTION && !isRos2Action(rule.type) -> listOfNotNull(
                advertisement("${rule.target}/goal", "${rule.type}Goal"),
                advertisement("${rule.target}/cancel", CANCEL_TYPE),
                operation("subscribe", "topic" to "${rule.target}/result", "type" to "${rule.type}Result"),
                rule.feedback?.let { operation("subscribe", "topic" to "${rule.target}/feedback", "type" to "${rule.type}Feedback") },
            )
            else -> emptyList()
        }
    }.distinct()

    private fun advertisement(topic: String, type: String) = operation("advertise", "topic" to topic, "type" to type)

    private fun ruleOf(command: GroundTerm.Structure?): CommandRule? {
        val functor = command?.predicate?.takeIf { it == Predicate(it.functor) }?.functor
        return rules.find { it.name == functor && it.parameters.size == command.arguments.size }
    }

    /** Returns false if the command [text] is only published. An unknown command gives true, and is refused when it is sent. */
    fun answers(text: String): Boolean = ruleOf(GroundTerm.ofOrNull(text) as? GroundTerm.Structure)?.kind != Kind.TOPIC

    fun send(text: String, options: SendOptions): SentCommand {
        val outcome = CompletableFuture<Answer>()
        val command = GroundTerm.ofOrNull(text) as? GroundTerm.Structure
        val arguments = command?.arguments.orEmpty()
        val rule = ruleOf(command)
            ?: return refused("the robot has no command $text; it has ${known()}")
        types.whyUnknown(rule)?.let { return refused("$text cannot leave, since the bridge does not know the type ${rule.type}: $it") }
        val body = try {
            bodyOf(rule, arguments)
        } catch (unfit: Unfit) {
            return refused("$text does not fit the robot: ${unfit.message}")
        }
        if (command?.annotations.orEmpty().isNotEmpty()) {
            warn("the annotations of the command ${rule.name}/${rule.parameters.size} are left out, since no message of ROS has any")
        }
        val id = "$session-${number.incrementAndGet()}"
        val message = Outgoing(messageOf(rule, body, id), options.urgent(), rule.name, options.latest())
        val entry = Pending(rule, text, message, outcome)
        pending[id] = entry
        outcome.whenComplete { _, _ -> ended(id, entry) }
        message.left.whenComplete { _, trouble -> left(entry, trouble) }
        graph.sends(rule) { reason -> lost(id, entry, reason) }
        send(message)
        if (!outcome.isDone) limit(id, entry, options.limitMillis())
        val giveUp = if (rule.kind == Kind.ACTION) ({ giveUp(id, entry) }) else null
        return SentCommand(outcome, CompletableFuture.anyOf(message.left, outcome).handle { _, _ -> }, giveUp)
    }

    private fun ended(id: String, entry: Pending) {
        pending -= id
        forgetFeedback(entry)
    }

    /** Forgets the feedback of an ended goal. Keeps the feedback of a later goal of the same rule. */
    private fun forgetFeedback(entry: Pending) {
        if (progressing.remove(entry.rule, entry)) entry.rule.feedback?.let { progress(it, null) }
    }

    private fun known() = rules.joinToString(", ") { "${it.name}/${it.parameters.size}" }.ifEmpty { "none" }

    private fun refused(reason: String) =
        SentCommand(CompletableFuture.failedFuture<Answer>(ActionRefusedException(port, "$reason (port $port)")))

    private fun limit(id: String, entry: Pending, limitMs: Int) {
        val ms = if (limitMs > 0) minOf(limitMs, entry.rule.withinMs) else entry.rule.withinMs
        clock.schedule(TimeUnit.MILLISECONDS.toNanos(ms.toLong())) { timeIsOver(id, ms) } // keeps no reference to the ended entry
    }

    private fun timeIsOver(id: String, ms: Int) {
        val entry = pending[id] ?: return
        abandon(id, entry, "has not left port $port within $ms ms", "the robot has not said it within $ms ms")
    }

    /** Ends the command of [entry] after the agent has dropped its intention. */
    private fun giveUp(id: String, entry: Pending) =
        abandon(id, entry, "had not left port $port when its intention was dropped", "its intention was dropped, and its goal is cancelled")

    private fun abandon(id: String, entry: Pending, ifWaiting: String, ifUnderWay: String) {
        if (entry.outcome.isDone) return
        if (entry.message.withdraw()) {
            entry.outcome.completeExceptionally(CommandWithdrawnException(port, "\"${entry.text}\" $ifWaiting, and never will"))
        } else if (entry.outcome.completeExceptionally(unconfirmed(entry, ifUnderWay))) {
            cancellation(entry.rule, id)?.let { send(Outgoing(it, isUrgent = true)) }
        }
    }

    /** Fails [entry], since no server has received its goal. Cancels the goal in case a server appears later. */
    private fun lost(id: String, entry: Pending, reason: String) {
        if (entry.outcome.isDone) return
        val hasLeft = !entry.message.withdraw()
        fail(entry, reason)
        if (hasLeft) cancellation(entry.rule, id)?.let { send(Outgoing(it, isUrgent = true)) }
    }

    private fun left(entry: Pending, trouble: Throwable?) {
        val cause = if (trouble is CompletionException) trouble.cause else trouble
        when (cause) {
            null -> if (entry.rule.kind == Kind.TOPIC) entry.outcome.complete(UNANSWERED)
            is Replaced -> entry.outcome.completeExceptionally(
                CommandReplacedException(port, "a later ${entry.rule.name} has taken the place of \"${entry.text}\" on port $port"),
            )
            is NeverSent -> entry.outcome.completeExceptionally(neverSent(entry, "the port was closed"))
            else -> entry.outcome.completeExceptionally(unconfirmed(entry, "the connection broke while it left"))
        }
    }

    private fun neverSent(entry: Pending, reason: String) = PortGoneException(port, "\"${entry.text}\" never left port $port: $reason")

    private fun unconfirmed(entry: Pending, reason: String): PortException =
        ActionUnconfirmedException(port, "it is not known what became of \"${entry.text}\": $reason (port $port)")

    fun cancellations(): List<Outgoing> = pending.entries.filter { (_, entry) -> entry.message.hasBegun }
        .mapNotNull { (id, entry) -> cancellation(entry.rule, id)?.let { Outgoing(it, isUrgent = true) } }

    fun gone(reason: String) = pending.values.forEach { entry ->
        entry.outcome.completeExceptionally(
            if (entry.message.withdraw()) neverSent(entry, reason) else unconfirmed(entry, reason),
        )
    }

    fun heard(operation: JsonObject): Boolean = when (operation.text("op")) {
        "service_response" -> pendingOf(operation)?.also { responded(it, operation) } != null
        "action_result" -> pendingOf(operation)?.also { resulted(it, operation) } != null
        "action_feedback" -> pendingOf(operation)?.also { progressed(it, operation.part("values")) } != null
        "publish" -> goalOf(operation)?.also { (entry, message) -> published(entry, message, operation.text("topic").orEmpty()) } != null
        else -> false
    }

    private fun pendingOf(operation: JsonObject): Pending? = operation.text("id")?.let(pending::get)

    private fun responded(entry: Pending, operation: JsonObject) {
        val values = operation.part("values")
        when {
            operation.flag("result") == false -> fail(entry, operation.text("values") ?: "${operation["values"] ?: "no reason is given"}")
            values?.flag("success") == false -> fail(entry, values.text("message").orEmpty().ifEmpty { "the service reports no success" })
            else -> succeed(entry, values)
        }
    }

    private fun progressed(entry: Pending, feedback: JsonObject?) {
        val rule = entry.rule.feedback ?: return
        if (feedback == null || entry.outcome.isDone) return
        progress(rule, feedback)
        progressing[entry.rule] = entry
        if (entry.outcome.isDone) forgetFeedback(entry) // the goal has ended meanwhile
    }

    private fun succeed(entry: Pending, response: JsonObject?) {
        val message = response ?: JsonObject(emptyMap())
        val scope = types.scopeOfAnswer(entry.rule, message)
        val answer = when (val term = (entry.rule.answer?.valueIn(scope) ?: Value.Part(message)).asTerm()) {
            is Value.Symbol -> Answer.of(term.text)
            is Value.None -> Answer.none("${entry.rule.target} gives no answer that the agent can have: ${term.why}")
            else -> error("${term.inWords()} is no term")
        }
        entry.outcome.complete(answer)
    }

    private fun resulted(entry: Pending, operation: JsonObject) {
        val status = operation.text("status")?.toIntOrNull()
        when {
            operation.flag("result") == false && status == null ->
                fail(entry, operation.text("values") ?: "${operation["values"] ?: "no reason is given"}")
            status == null || status == SUCCEEDED_2 -> succeed(entry, operation.part("values"))
            else -> {
                val reason = operation.part("values")?.text("message").orEmpty()
                fail(entry, "its goal was ${STATES_2[status] ?: "left in state $status"}" + if (reason.isEmpty()) "" else ": $reason")
            }
        }
    }

    /** Returns the command for a ROS 1 result or feedback, and the message. */
    private fun goalOf(operation: JsonObject): Pair<Pending, JsonObject>? {
        val message = operation.part("msg") ?: return null
        val entry = message.part("status")?.part("goal_id")?.text("id")?.let(pending::get) ?: return null
        return (entry to message).takeIf { operation.text("topic")?.substringAfterLast('/') in setOf("result", "feedback") }
    }

    private fun published(entry: Pending, message: JsonObject, topic: String) =
        if (topic.endsWith("/result")) resultPublished(entry, message) else progressed(entry, message.part("feedback"))

    private fun resultPublished(entry: Pending, message: JsonObject) {
        val status = message.part("status")
        val state = status?.text("status")?.toIntOrNull()
        if (state == SUCCEEDED_1) return succeed(entry, message.part("result"))
        val reason = "its goal was ${STATES_1[state] ?: "left in state $state"}" +
            status?.text("text").orEmpty().let { if (it.isEmpty()) "" else ": $it" }
        if (state != REJECTED_1) fail(entry, reason)
        else entry.outcome.completeExceptionally(ActionRefusedException(port, "the robot refuses \"${entry.text}\": ${shown(reason)}"))
    }

    private fun fail(entry: Pending, reason: String) {
        val why = "the robot could not do \"${entry.text}\": ${shown(reason)} (port $port)"
        entry.outcome.completeExceptionally(ActionFailedException(port, why))
    }

    private fun shown(reason: String) = foreignText(reason, first = MAX_REASON)

    /** @throws Unfit if a field cannot have its value */
    private fun bodyOf(rule: CommandRule, arguments: List<GroundTerm>): JsonObject {
        val values = rule.parameters.zip(arguments) { name, term -> name to valueOf(term) }.toMap()
        val scope = Scope { path -> values.getValue(written(path)) }
        val type = types.of(rule)
        return nested(
            rule.fields.map { field ->
                val value = field.value.valueIn(scope)
                if (value is Value.None) throw Unfit("${field.path.joinToString(".")}: ${value.why}")
                field.path to (type?.fit(field.steps, value.asJson()) ?: value.asJson())
            },
        )
    }

    private fun messageOf(rule: CommandRule, body: JsonObject, id: String): String = when {
        rule.kind == Kind.TOPIC -> operation("publish", "topic" to rule.target, "msg" to body)
        rule.kind == Kind.SERVICE ->
            operation("call_service", "id" to id, "service" to rule.target, "type" to rule.type, "args" to body)
        isRos2Action(rule.type) ->
            operation(
                "send_action_goal", "id" to id, "action" to rule.target, "action_type" to rule.type, "args" to body,
                "feedback" to true.takeIf { rule.feedback != null },
            )
        else -> operation("publish", "topic" to "${rule.target}/goal", "msg" to JsonObject(mapOf("goal_id" to goalId(id), "goal" to body)))
    }

    private fun cancellation(rule: CommandRule, id: String): String? = when {
        rule.kind != Kind.ACTION -> null
        isRos2Action(rule.type) -> operation("cancel_action_goal", "id" to id, "action" to rule.target)
        else -> operation("publish", "topic" to "${rule.target}/cancel", "msg" to goalId(id))
    }

    private fun goalId(id: String) = JsonObject(mapOf("id" to JsonPrimitive(id)))

    private companion object {
        val UNANSWERED = Answer.none("nobody answers a message of a topic")
        const val MAX_REASON = 1000 // characters
        const val CANCEL_TYPE = "actionlib_msgs/GoalID"

        // actionlib_msgs/GoalStatus
        const val SUCCEEDED_1 = 3
        const val REJECTED_1 = 5
        val STATES_1 = mapOf(2 to "preempted", 4 to "aborted", REJECTED_1 to "rejected", 8 to "recalled", 9 to "lost")

        // action_msgs/msg/GoalStatus
        const val SUCCEEDED_2 = 4
        val STATES_2 = mapOf(5 to "cancelled", 6 to "aborted")
    }
}

private fun valueOf(term: GroundTerm): Value = when (term) {
    is GroundTerm.Number -> Value.of(term.value)
    is GroundTerm.Text -> Value.Text(term.text)
    is GroundTerm.Structure -> Value.Symbol("$term")
    is GroundTerm.Sequence -> {
        val items = term.items.map(::valueOf)
        items.find { it is Value.None } ?: Value.Part(JsonArray(items.map { it.asJson() }))
    }
}

private fun nested(fields: List<Pair<List<String>, JsonElement>>): JsonObject = JsonObject(
    fields.groupBy({ (path, _) -> path.first() }, { (path, value) -> path.drop(1) to value }).mapValues { (_, inside) ->
        inside.singleOrNull { (path, _) -> path.isEmpty() }?.second ?: nested(inside)
    },
)
