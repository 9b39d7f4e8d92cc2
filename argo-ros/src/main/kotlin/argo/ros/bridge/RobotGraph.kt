package argo.ros.bridge

import argo.ros.mapping.CommandRule
import argo.ros.mapping.CommandRule.Kind
import argo.ros.mapping.Mapping
import argo.ros.mapping.isRos2Action
import argo.ros.mapping.rosType
import javino.LineClock
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentHashMap

/** Asks `rosapi` for the other nodes of the robot. Warns of topics and commands that no node serves. Safe for use by several threads. */
internal class RobotGraph(
    private val mapping: Mapping,
    private val api: RosApi,
    private val clock: LineClock,
    private val warn: (String) -> Unit,
) {
    private val askedNanos = ConcurrentHashMap<String, Long>() // the time of the last question, by command topic

    /** Compares the mapping's types with the robot's topics, and looks for the mapping's actions. */
    fun check() {
        val topics = (mapping.percepts - mapping.poses.toSet()).map { it.topic to it.type } + mapping.commands.mapNotNull(::topicOf)
        topics.distinct().forEach { (topic, type) -> compareType(topic, type) }
        mapping.commands.filter { it.kind == Kind.SERVICE }.distinctBy { it.target }.forEach(::lookForService)
        mapping.commands.filter { it.kind == Kind.ACTION }.distinctBy { it.target }.forEach { rule ->
            ifMissing(rule) { warn("rosapi shows no action server ${rule.target} yet") }
        }
    }

    private fun lookForService(rule: CommandRule) {
        if ("/_" in rule.target) return // rosapi does not show hidden services
        api.ask("/rosapi/service_type", mapOf("service" to rule.target)).thenAccept { answer ->
            val type = answer.text("type") ?: return@thenAccept
            if (type.isEmpty()) warn("rosapi shows no service ${rule.target} yet")
            else if (bareType(type) != bareType(rule.type)) {
                warn("${rule.target} is of type $type on the robot, and the mapping says ${rule.type}")
            }
        }
    }

    private fun bareType(type: String) = type.replace("/srv/", "/")

    private fun topicOf(rule: CommandRule): Pair<String, String>? = when {
        rule.kind == Kind.TOPIC -> rule.target to rule.type
        rule.kind == Kind.ACTION && !isRos2Action(rule.type) -> "${rule.target}/goal" to "${rule.type}Goal"
        else -> null
    }

    private fun compareType(topic: String, type: String) = typeOf(topic).thenApply { known ->
        if (known.isNotEmpty() && rosType(known) != rosType(type)) {
            warn("$topic is of type $known on the robot, and the mapping says $type: its messages do not pass the bridge")
        }
        known
    }

    private fun typeOf(topic: String): CompletableFuture<String> =
        api.ask("/rosapi/topic_type", mapOf("topic" to topic)).thenApply { it.text("type").orEmpty() }

    /** Warns if [topic] is silent because no message can come. */
    fun explainSilence(topic: String, type: String) {
        compareType(topic, type)
        api.ask("/rosapi/publishers", mapOf("topic" to topic)).whenComplete { answer, trouble ->
            if (answer?.texts("publishers")?.isEmpty() == true) warn("no node publishes $topic")
            else if ((trouble as? RosApi.NotKnown)?.isMissing == true) warn("nothing has come of $topic; does a node publish it?")
        }
    }

    /**
     * Call this function before sending a command of [rule]. Warns if no node takes the command. A topic is checked at most once in
     * [AGAIN_NANOS]. If the command's goal reaches no server, [lost] is called with the reason. In ROS 2 this is uncertain, so this
     * function only warns.
     */
    fun sends(rule: CommandRule, lost: (String) -> Unit) {
        val reason = "rosapi shows no action server ${rule.target}"
        when {
            rule.kind == Kind.ACTION -> ifMissing(rule) {
                if (isRos2Action(rule.type)) warn("$reason; a goal waits for one until its time is over") else lost(reason)
            }
            rule.kind == Kind.TOPIC && isDue(rule.target) -> lookForSubscribers(rule)
        }
    }

    /**
     * Looks for subscribers of the rule's topic. The bridge itself publishes on the topic. If `rosapi` does not show the topic even so, the
     * topic is hidden.
     */
    private fun lookForSubscribers(rule: CommandRule) {
        compareType(rule.target, rule.type).thenCompose { type ->
            if (type.isEmpty()) CompletableFuture.completedFuture(null)
            else api.ask("/rosapi/subscribers", mapOf("topic" to rule.target)).thenApply { it.texts("subscribers") }
        }.thenAccept { if (it?.isEmpty() == true) warn("no node subscribes to ${rule.target}, so that \"${rule.name}\" does nothing") }
    }

    private fun isDue(topic: String): Boolean {
        val now = clock.nanos()
        return askedNanos.compute(topic) { _, before -> if (before == null || now - before >= AGAIN_NANOS) now else before } == now
    }

    /** Does [work] if `rosapi` shows an action's topics but not its server. An action client also creates the topics. */
    private fun ifMissing(rule: CommandRule, work: () -> Unit) {
        val isShown = if (isRos2Action(rule.type)) CompletableFuture.completedFuture("") else typeOf("${rule.target}/goal")
        isShown.thenCompose { type ->
            if (type.isEmpty() && !isRos2Action(rule.type)) CompletableFuture.completedFuture(null)
            else api.ask("/rosapi/action_servers").thenApply { it.texts("action_servers") }
        }.thenAccept { servers -> if (servers?.none { absolute(it) == absolute(rule.target) } == true) work() }
    }

    private fun absolute(name: String) = "/${name.removePrefix("/")}"

    private companion object {
        val AGAIN_NANOS = SilentTopics.LIMIT_NANOS
    }
}
