package argo.ros.bridge

import javino.LineClock
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.Executor

/**
 * A bridge within this program, for tests and bags. The bridge answers at once, on the caller's thread. Services and goals succeed with the
 * response that the test has set. The bridge answers `rosapi` questions from the bag.
 *
 * @param bag the bag to play, or null if the caller publishes messages with [publish]
 * @param worker reads the bag, one task at a time
 * @param heard takes the name of the topic, service or action, and the message, request or goal
 */
internal class PlayedBridge(
    private val listener: BridgeListener,
    clock: LineClock,
    private val bag: Bag? = null,
    worker: Executor = Executor(Runnable::run),
    private val heard: (name: String, message: String) -> Unit,
) : Bridge {
    private val player = bag?.let { BagPlayer(it, clock, worker, ::isSubscribed, ::publish, listener::told) }
    private val responses = ConcurrentHashMap<String, JsonObject>() // by service or action name
    private val subscribed = ConcurrentHashMap.newKeySet<String>()
    private val outbox = Outbox { text ->
        answer(checkNotNull(operationIn(text)))
        CompletableFuture.completedFuture(Unit)
    }

    override fun queue(message: Outgoing) = outbox.add(message)

    override fun flush() = outbox.flush()

    override fun ping() = listener.isAlive()

    fun respond(service: String, response: JsonObject) {
        responses[service] = response
    }

    private fun responseOf(name: String) = responses[name] ?: JsonObject(emptyMap())

    fun publish(topic: String, message: JsonObject) {
        if (topic in subscribed) listener.text(operation("publish", "topic" to topic, "msg" to message))
    }

    private fun isSubscribed(topic: String) = topic in subscribed

    fun end() = listener.gone("the bridge has closed the connection")

    private fun answer(operation: JsonObject) {
        val topic = operation.text("topic").orEmpty()
        when (operation.text("op")) {
            "subscribe" -> {
                subscribed += topic
                player?.subscribed(topic)
            }
            "unsubscribe" -> subscribed -= topic
            "publish" -> published(topic, operation.part("msg") ?: return)
            "call_service" -> called(operation)
            "send_action_goal" -> {
                heard(operation.text("action").orEmpty(), "${operation["args"]}")
                val result = responseOf(operation.text("action").orEmpty())
                val id = operation.text("id")
                listener.text(operation("action_result", "id" to id, "status" to SUCCEEDED_2, "values" to result, "result" to true))
            }
        }
    }

    private fun published(topic: String, message: JsonObject) {
        val goal = message.part("goal_id").takeIf { topic.endsWith(GOAL) } ?: return heard(topic, "$message")
        val action = topic.removeSuffix(GOAL)
        heard(action, "${message["goal"]}")
        val status = JsonObject(mapOf("goal_id" to goal, "status" to JsonPrimitive(SUCCEEDED_1)))
        publish("$action/result", JsonObject(mapOf("status" to status, "result" to responseOf(action))))
    }

    private fun called(operation: JsonObject) {
        val service = operation.text("service").orEmpty()
        val isOfApi = service.startsWith("/rosapi/")
        val response = if (isOfApi) bag?.answer(service, operation.part("args") ?: return) else responseOf(service)
        if (!isOfApi) heard(service, "${operation["args"] ?: JsonArray(emptyList())}")
        val values = response ?: JsonPrimitive("") // a refusal without a reason
        listener.text(operation("service_response", "id" to operation.text("id"), "values" to values, "result" to (response != null)))
    }

    override fun close() {
        player?.close()
        outbox.close()
    }

    private companion object {
        const val GOAL = "/goal"
        const val SUCCEEDED_1 = 3 // actionlib_msgs/GoalStatus
        const val SUCCEEDED_2 = 4 // action_msgs/msg/GoalStatus
    }
}
