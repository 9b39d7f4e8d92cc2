package argo.ros.joining

import argo.ros.bridge.operation
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * The topics and the recent goals of a ROS 1 action, in the format of `actionlib`. Safe for use by several threads. [action] is the
 * action's name, such as `/uno/act`.
 */
internal class ActGoals(private val action: String, private val send: (String) -> Unit) {
    private class Goal(val id: String, var state: Int, var text: String)

    private val goals = ArrayDeque<Goal>() // guarded by this
    private var number = 0L

    val goalTopic = "$action/goal"

    val cancelTopic = "$action/cancel"
    private val statusTopic = "$action/status"
    private val resultTopic = "$action/result"

    private val published = mapOf(
        statusTopic to "actionlib_msgs/GoalStatusArray", resultTopic to "argo_msgs/ActActionResult",
        "$action/feedback" to "argo_msgs/ActActionFeedback",
    )

    fun announce() {
        published.forEach { (topic, type) ->
            send(operation("advertise", "topic" to topic, "type" to type, "latch" to (topic == statusTopic)))
        }
        send(operation("subscribe", "topic" to goalTopic, "type" to "argo_msgs/ActActionGoal"))
        send(operation("subscribe", "topic" to cancelTopic, "type" to "actionlib_msgs/GoalID"))
        synchronized(this) { report() } // clients wait for a first status
    }

    /** Registers the goal [id] and returns its name. Makes a name if [id] is empty. Returns null if the goal is already registered. */
    fun begin(id: String): String? = synchronized(this) {
        val name = id.ifEmpty { "argo-goal-${++number}" }
        if (goals.any { it.id == name }) return null
        goals.addLast(Goal(name, ACTIVE, ""))
        if (goals.size > KEPT) goals.removeFirst()
        report()
        name
    }

    fun end(id: String, outcome: Outcome) = synchronized(this) {
        val state = if (outcome.error == null) SUCCEEDED else ABORTED // actionlib does not allow an active goal to become rejected
        val text = if (outcome.error == null) "" else outcome.inWords
        goals.find { it.id == id }?.let {
            it.state = state
            it.text = text
        }
        report()
        publish(resultTopic, false, mapOf("status" to stateOf(id, state, text), "result" to outcome.response))
    }

    private fun report() =
        publish(statusTopic, true, mapOf("status_list" to JsonArray(goals.map { stateOf(it.id, it.state, it.text) })))

    private fun publish(topic: String, latch: Boolean, message: Map<String, JsonElement>) =
        send(operation("publish", "topic" to topic, "msg" to JsonObject(message), "latch" to latch))

    private fun stateOf(id: String, state: Int, text: String) = JsonObject(
        mapOf(
            "goal_id" to JsonObject(mapOf("id" to JsonPrimitive(id))), "status" to JsonPrimitive(state), "text" to JsonPrimitive(text),
        ),
    )

    private companion object {
        /** The number of goals whose states are kept. A repeated goal is recognised only while its state is kept. */
        const val KEPT = 50

        // actionlib_msgs/GoalStatus
        const val ACTIVE = 1
        const val SUCCEEDED = 3
        const val ABORTED = 4
    }
}
