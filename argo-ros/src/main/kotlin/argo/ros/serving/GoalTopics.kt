package argo.ros.serving

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.util.concurrent.atomic.AtomicLong

/**
 * Publishes the states and results of goals as actions of ROS 1 do, on the topics `status` and `result`; goals come by the topic `goal`.
 * Safe for use by several threads.
 */
internal class GoalTopics(private val topics: Topics) {
    private class Goal(val id: String, var state: Int, var text: String)

    private val goals = HashMap<String, ArrayDeque<Goal>>() // by action; the last goals of each
    private val number = AtomicLong()

    /** Publishes the states of [action] if they never were: by them clients see that the server is there. */
    fun announce(action: String) = synchronized(this) {
        if (topics.newest("$action/$STATUS") == null) report(action)
    }

    /** Notes a goal for [action]; false: it had come before, and is not to be carried out again. */
    fun begin(action: String, id: String): Boolean = synchronized(this) {
        if (goals.size >= MAX_ACTIONS && action !in goals) return false
        val its = goals.getOrPut(action, ::ArrayDeque)
        if (its.any { it.id == id }) return false
        its.addLast(Goal(id, ACTIVE, ""))
        if (its.size > KEPT) its.removeFirst()
        report(action)
        true
    }

    /** Makes a name for a goal that has none. */
    fun newId(): String = "argo-goal-${number.incrementAndGet()}"

    /** Publishes that the goal [id] of [action] is over. */
    fun end(action: String, id: String, outcome: Outcome) = synchronized(this) {
        val state = if (outcome.error == null) SUCCEEDED else if (outcome.error == REFUSED) REJECTED else ABORTED
        goals[action]?.find { it.id == id }?.let {
            it.state = state
            it.text = outcome.message
        }
        report(action)
        val message = mapOf("header" to HEADER, "status" to stateOf(id, state, outcome.message), "result" to resultOf(outcome))
        topics.publish("$action/$RESULT", RESULT_TYPE, JsonObject(message), isEvent = true)
    }

    private fun report(action: String) {
        val list = goals[action].orEmpty().map { stateOf(it.id, it.state, it.text) }
        topics.publish("$action/$STATUS", STATUS_TYPE, JsonObject(mapOf("header" to HEADER, "status_list" to JsonArray(list))))
    }

    private fun stateOf(id: String, state: Int, text: String) = JsonObject(
        mapOf(
            "goal_id" to JsonObject(mapOf("stamp" to NO_TIME, "id" to JsonPrimitive(id))),
            "status" to JsonPrimitive(state),
            "text" to JsonPrimitive(text),
        ),
    )

    companion object {
        const val GOAL = "goal"
        const val CANCEL = "cancel"
        const val STATUS = "status"
        const val RESULT = "result"
        private const val STATUS_TYPE = "actionlib_msgs/GoalStatusArray"
        private const val RESULT_TYPE = "argo_msgs/CommandActionResult"

        /** The number of an action's goals whose states are kept. A goal that comes again within so many others is recognised. */
        private const val KEPT = 100
        private const val MAX_ACTIONS = 300

        // actionlib_msgs/GoalStatus
        private const val ACTIVE = 1
        private const val SUCCEEDED = 3
        private const val ABORTED = 4
        private const val REJECTED = 5
        private const val REFUSED = "act_refused"

        private val NO_TIME = JsonObject(mapOf("secs" to JsonPrimitive(0), "nsecs" to JsonPrimitive(0)))
        private val HEADER =
            JsonObject(mapOf("seq" to JsonPrimitive(0), "stamp" to NO_TIME, "frame_id" to JsonPrimitive("")))
    }
}

/** Makes the response of a service, which is also the result of an action. */
internal fun resultOf(outcome: Outcome) = JsonObject(
    mapOf("success" to JsonPrimitive(outcome.error == null), "message" to JsonPrimitive(outcome.message)) +
        outcome.error?.let { mapOf("error" to JsonPrimitive(it)) }.orEmpty(),
)
