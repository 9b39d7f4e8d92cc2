package argo.ros.serving

import argo.ros.bridge.operation
import argo.ros.bridge.operationIn
import argo.ros.bridge.part
import argo.ros.bridge.text
import javino.SendOptions
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger

/**
 * Carries out the requests of a client of the rosbridge protocol. [hear] is for one thread at a time.
 *
 * @param subscriber sends to the client
 * @param leave ends the connection, for a reason
 * @param nanos the time
 */
internal class Client(
    private val graph: Graph,
    private val rosApi: RosApiServices,
    private val subscriber: Subscriber,
    private val leave: (String) -> Unit,
    private val nanos: () -> Long,
) {
    private val rate = Rate(nanos())
    private val underWay = AtomicInteger()
    private val goals = ConcurrentHashMap.newKeySet<String>()

    /** Takes [text], any message of the client. */
    fun hear(text: String) {
        if (!counts()) return
        val operation = operationIn(text)
        val op = operation?.text("op")
        if (operation == null || op == null) return complain("this is no operation of the rosbridge protocol: ${text.take(QUOTED)}", null)
        try {
            hear(op, operation)
        } catch (refused: RefusedRequest) {
            complain(refused.message.orEmpty(), operation.text("id"))
        }
    }

    /** Counts a message; false: there were too many, and the client is disconnected. */
    fun counts(): Boolean {
        subscriber.isAlive()
        if (rate.isWithin(nanos())) return true
        leave("more than ${Rate.PER_SECOND} messages a second")
        return false
    }

    private fun hear(op: String, operation: JsonObject) {
        when (op) {
            "subscribe" -> subscribe(operation)
            "unsubscribe" -> subscriber.unsubscribe(absolute(topicIn(operation)), operation.text("id"))
            "publish" -> publish(absolute(topicIn(operation)), operation["msg"])
            "call_service" -> call(operation)
            "send_action_goal" -> sendGoal(operation)
            "cancel_action_goal" -> cancel()
            "advertise", "unadvertise", "set_level", "auth" -> Unit // publishers need no announcement here
            else -> throw RefusedRequest("the operation $op is not known here")
        }
    }

    private fun topicIn(operation: JsonObject) =
        operation.text("topic")?.takeIf { it.length <= MAX_NAME } ?: throw RefusedRequest("${operation.text("op")} names no topic")

    private fun subscribe(operation: JsonObject) {
        val asked = topicIn(operation)
        val topic = absolute(asked)
        val compression = operation.text("compression")
        if (compression != null && compression != "none") {
            complain("$topic comes as JSON, the compression $compression is not known here", null)
        }
        val (type, known) = operation.text("type") to graph.topics.types[topic]
        if (type != null && known != null && type.replace("/msg/", "/") != known) complain("$topic is of type $known, and not $type", null)
        val action = topic.removeSuffix("/${GoalTopics.STATUS}")
        val target = if (action == topic) null else graph.targetOrNull(action)
        if (target?.mayExist == true) graph.goals.announce(action)
        val isTaken = subscriber.subscribe(
            topic, operation.text("id").orEmpty(), numberIn(operation, "throttle_rate"), numberIn(operation, "queue_length").toInt(),
            graph.topics.newest(topic), asked,
        )
        if (!isTaken) throw RefusedRequest("$topic is one too many: a client has ${Subscriber.MAX_SUBSCRIPTIONS} subscriptions at most")
    }

    /** Adds the first slash of a name, which clients may omit. */
    private fun absolute(name: String) = "/${name.removePrefix("/")}"

    private fun numberIn(operation: JsonObject, name: String): Long =
        (operation[name] as? JsonPrimitive)?.doubleOrNull?.toLong()?.coerceIn(0, Int.MAX_VALUE.toLong()) ?: 0

    private fun publish(topic: String, message: JsonElement?) {
        val (name, kind) = topic.substringBeforeLast('/') to topic.substringAfterLast('/')
        when (kind) {
            COMMAND -> act(name, message, NEWEST) { if (it.error != null) complain("$topic: ${it.message}", null) }
            GoalTopics.GOAL -> goal(name, message as? JsonObject ?: throw RefusedRequest("a goal is an object"))
            GoalTopics.CANCEL -> cancel()
            else -> throw RefusedRequest("nobody takes what is published on $topic; a command is published on …/ACTION/$COMMAND")
        }
    }

    /** Has the [service] carried out, or throws. */
    private fun act(service: String, request: JsonElement?, options: SendOptions, done: (Outcome) -> Unit) {
        val target = graph.target(service)
        val participant = target.participant
        val isWritten = target.action == Target.ACT
        val command = if (isWritten) writtenCommand(writtenIn(request)) else commandOf(target.action, request, participant.actions)
        if (underWay.incrementAndGet() > MAX_UNDER_WAY) {
            underWay.decrementAndGet()
            throw RefusedRequest("$MAX_UNDER_WAY commands of this client are under way; $service is not begun")
        }
        participant.act(command, options) {
            underWay.decrementAndGet()
            done(it)
        }
    }

    private fun writtenIn(request: JsonElement?): String? = when (request) {
        is JsonObject -> request.text("command") ?: request.text("data")
        is JsonPrimitive -> request.content
        else -> null
    }

    private fun call(operation: JsonObject) {
        val service = operation.text("service") ?: throw RefusedRequest("call_service names no service")
        val id = operation.text("id")
        fun respond(values: JsonElement, result: Boolean) = subscriber.send(
            operation("service_response", "id" to id, "service" to service, "values" to values, "result" to result),
        )
        try {
            if (absolute(service).startsWith(RosApiServices.BASE)) {
                return respond(rosApi.answer(absolute(service), operation.part("args") ?: JsonObject(emptyMap())), true)
            }
            act(service, operation["args"], optionsIn(operation)) { respond(resultOf(it), true) }
        } catch (refused: RefusedRequest) {
            respond(JsonPrimitive(refused.message.orEmpty()), false)
        }
    }

    /** `timeout` is in seconds. */
    private fun optionsIn(operation: JsonObject): SendOptions {
        val seconds = (operation["timeout"] as? JsonPrimitive)?.doubleOrNull ?: 0.0
        val ms = seconds * TimeUnit.SECONDS.toMillis(1)
        return if (ms >= 1) SendOptions(false, ms.coerceAtMost(MAX_LIMIT_MS).toInt()) else SendOptions.defaults()
    }

    private fun sendGoal(operation: JsonObject) {
        val action = operation.text("action") ?: throw RefusedRequest("send_action_goal names no action")
        val id = operation.text("id") ?: throw RefusedRequest("send_action_goal has no id")
        fun end(values: JsonObject, status: Int, result: Boolean) = subscriber.send(
            operation("action_result", "id" to id, "action" to action, "values" to values, "status" to status, "result" to result),
        )
        if (!goals.add(id)) throw RefusedRequest("the goal $id is under way already, and is not begun again")
        try {
            act(action, operation["args"], SendOptions.defaults()) {
                goals -= id
                end(resultOf(it), if (it.error == null) SUCCEEDED else ABORTED, it.error == null)
            }
        } catch (refused: RefusedRequest) {
            goals -= id
            end(resultOf(Outcome("act_refused", refused.message.orEmpty())), ABORTED, false)
        }
    }

    private fun goal(action: String, message: JsonObject) {
        val id = message.part("goal_id")?.text("id")?.takeIf { it.isNotEmpty() } ?: graph.goals.newId()
        graph.target(action) // so that no state is kept for topics that do not exist
        if (!graph.goals.begin(action, id)) throw RefusedRequest("the goal $id has come before, and is not begun again")
        try {
            act(action, message["goal"], SendOptions.defaults()) { graph.goals.end(action, id, it) }
        } catch (refused: RefusedRequest) {
            graph.goals.end(action, id, Outcome("act_refused", refused.message.orEmpty()))
        }
    }

    private fun cancel(): Nothing = throw RefusedRequest("a command cannot be taken back; the goal goes on until its board has acted")

    private fun complain(message: String, id: String?) =
        subscriber.send(operation("status", "level" to "error", "msg" to message, "id" to id))

    /** Counts the messages of a second. */
    private class Rate(private var startNanos: Long) {
        private var count = 0

        fun isWithin(nowNanos: Long): Boolean {
            if (nowNanos - startNanos >= TimeUnit.SECONDS.toNanos(1)) {
                startNanos = nowNanos
                count = 0
            }
            return ++count <= PER_SECOND
        }

        companion object {
            const val PER_SECOND = 5_000
        }
    }

    private companion object {
        /** The last part of the topic of a command. */
        const val COMMAND = "command"
        const val QUOTED = 60
        const val MAX_NAME = 500
        const val MAX_UNDER_WAY = 100
        const val MAX_LIMIT_MS = 600_000.0

        // action_msgs/msg/GoalStatus
        const val SUCCEEDED = 4
        const val ABORTED = 6

        /** The newest command of a topic replaces those that wait. */
        val NEWEST = SendOptions(false, 0, true)
    }
}
