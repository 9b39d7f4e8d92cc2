package argo.ros.joining

import argo.filters.foreignText
import argo.ros.bridge.operation
import argo.ros.bridge.part
import argo.ros.bridge.text
import javino.link.SendOptions
import kotlinx.serialization.json.JsonObject
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicInteger

/**
 * The services, topics and the ROS action that a participant offers on one connection. The graph uses them to send commands to the
 * participant. Each action of the participant has its own service and topic. A general service, topic and ROS action take any command. One
 * thread may call [hear] while another calls [renew]. [warn] takes reports of actions that cannot be offered, each text once.
 */
internal class AdvertisedServices(
    private val participant: Participant,
    private val send: (String) -> Unit,
    private val warn: (String) -> Unit,
) {
    /** @property action the action's name; null: any command, as text */
    private data class Offer(val action: String?, val arities: Set<Int>) {
        val isPlain get() = arities.singleOrNull() == 0
        val serviceType get() = if (action == null) ACT_TYPE else if (isPlain) "std_srvs/Trigger" else "argo_msgs/Command"
        val topicType get() = if (action == null) STRING else when (arities.singleOrNull()) {
            0 -> "std_msgs/Empty"
            1 -> NUMBER
            2 -> "geometry_msgs/Twist"
            else -> NUMBERS
        }
    }

    private val base = "/${participant.name}"
    private val action = "$base/$ACT"
    private val offers = ConcurrentHashMap<String, Offer>() // by service name
    private val underWay = AtomicInteger()
    private val goals = ActGoals(action, send)

    val services: Map<String, String> get() = offers.mapValues { it.value.serviceType }

    val topics: Map<String, String> get() = offers.entries.associate { (name, offer) -> topicOf(name) to offer.topicType }

    /** Advertises new actions and withdraws those that no longer exist. Returns true if there is a new offer. */
    fun renew(): Boolean {
        val wanted = wanted()
        (offers.keys - wanted.keys).forEach(::takeBack)
        val news = wanted.filter { offers[it.key] != it.value }
        for ((name, offer) in news) {
            if (offers.containsKey(name)) takeBack(name)
            offers[name] = offer
            send(operation("advertise_service", "service" to name, "type" to offer.serviceType))
            send(operation("subscribe", "topic" to topicOf(name), "type" to offer.topicType))
        }
        return news.isNotEmpty()
    }

    fun announceAction(isRos2: Boolean) =
        if (isRos2) send(operation("advertise_action", "action" to action, "type" to "argo_msgs/action/Act")) else goals.announce()

    /** Withdraws all services. A ROS 1 bridge keeps the services of a lost client. Callers of these services would wait for ever. */
    fun takeAllBack() = offers.keys.forEach(::takeBack)

    private fun takeBack(name: String) {
        val offer = offers.remove(name) ?: return
        send(operation("unadvertise_service", "service" to name, "type" to offer.serviceType))
        send(operation("unsubscribe", "topic" to topicOf(name)))
    }

    private fun topicOf(service: String) = if (service == action) "$base/$COMMAND" else "$service/$COMMAND"

    private fun wanted(): Map<String, Offer> {
        val actions = participant.actions.orEmpty().groupBy { graphName(it.name) }
        if (ACT in actions) warn("the action act has no service of its own, since $action takes any command as text")
        actions.values.filter { its -> its.any { it.name != its[0].name } }.forEach { its ->
            warn("${its.map { it.name }.distinct().joinToString()} are one name to ROS, and only ${its[0].name} has a service")
        }
        val named = (actions - ACT).map { (name, its) ->
            "$base/$name" to Offer(its[0].name, its.filter { it.name == its[0].name }.map { it.arguments }.toSet())
        }
        return named.toMap() + (action to Offer(null, emptySet()))
    }

    /** Handles an operation of the bridge; returns false if the operation is not about an offer. */
    fun hear(operation: JsonObject): Boolean {
        when (operation.text("op")) {
            "call_service" -> called(operation)
            "publish" -> return published(operation.text("topic").orEmpty(), operation.part("msg") ?: JsonObject(emptyMap()))
            "send_action_goal" -> goalSent(operation)
            "cancel_action_goal" -> warn(UNCANCELLED)
            else -> return false
        }
        return true
    }

    private fun called(operation: JsonObject) {
        val service = operation.text("service").orEmpty()
        val id = operation.text("id")
        act(offers[service], service, operation.part("args"), SendOptions.defaults()) {
            send(operation("service_response", "id" to id, "service" to service, "values" to it.response, "result" to true))
        }
    }

    private fun published(topic: String, message: JsonObject): Boolean {
        when {
            topic == goals.goalTopic -> goalPublished(message)
            topic == goals.cancelTopic -> warn(UNCANCELLED)
            topic.endsWith("/$COMMAND") -> {
                val service = offers.keys.find { topicOf(it) == topic }.orEmpty()
                act(offers[service], topic, message, NEWEST) { if (it.error != null) warn("$topic: ${foreignText(it.inWords)}") }
            }
            else -> return false
        }
        return true
    }

    private fun goalPublished(message: JsonObject) {
        val given = message.part("goal_id")?.text("id").orEmpty()
        val id = goals.begin(given) ?: return warn("the goal ${foreignText(given)} of $action has come before, and is not begun again")
        act(offers[action], action, message.part("goal"), SendOptions.defaults()) { goals.end(id, it) }
    }

    private fun goalSent(operation: JsonObject) = act(offers[action], action, operation.part("args"), SendOptions.defaults()) {
        val status = if (it.error == null) SUCCEEDED else ABORTED
        val (id, name) = operation.text("id") to operation.text("action")
        // if result is false, the bridge drops the values
        send(operation("action_result", "id" to id, "action" to name, "values" to it.response, "status" to status, "result" to true))
    }

    /** Passes the command in [request] to the participant. Calls [done] once with the outcome. */
    private fun act(offer: Offer?, name: String, request: JsonObject?, options: SendOptions, done: (Outcome) -> Unit) {
        val command = try {
            offer ?: throw RefusedRequest("there is no $name any more")
            val given = request ?: JsonObject(emptyMap())
            if (underWay.get() >= MAX_UNDER_WAY) throw RefusedRequest("$MAX_UNDER_WAY commands are under way; $name is not begun")
            if (offer.action == null) writtenCommand(given) else commandOf(offer.action, given, participant.actions)
        } catch (refused: RefusedRequest) {
            return done(Outcome(Outcome.REFUSED, refused.message.orEmpty()))
        }
        underWay.incrementAndGet()
        participant.act(command, options) {
            underWay.decrementAndGet()
            done(it)
        }
    }

    private companion object {
        /** The name of the service and the action that take any command. */
        const val ACT = "act"
        const val ACT_TYPE = "argo_msgs/Act"

        const val COMMAND = "command"
        const val MAX_UNDER_WAY = 100
        const val UNCANCELLED = "a goal is not cancelled: a board takes no command back, and the goal goes on until the board has acted"

        // action_msgs/msg/GoalStatus
        const val SUCCEEDED = 4
        const val ABORTED = 6

        /** A new command of a topic replaces the topic's waiting commands. */
        val NEWEST = SendOptions(false, 0, true)
    }
}
