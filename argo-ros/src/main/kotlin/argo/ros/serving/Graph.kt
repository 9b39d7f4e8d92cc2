package argo.ros.serving

import javino.wire.BoardAction
import java.util.concurrent.CopyOnWriteArrayList

/** Boards and agents with their topics, services and actions, as clients see them. Safe for use by several threads. */
internal class Graph(warn: (String) -> Unit) {
    /** Their topics. */
    val topics = Topics(warn)

    /** The goals of actions as ROS 1 has them. */
    val goals = GoalTopics(topics)
    private val participants = CopyOnWriteArrayList<Participant>()

    /** True if nobody takes part. */
    val isEmpty: Boolean get() = participants.isEmpty()

    /** The names of the participants, as nodes. */
    val nodes: List<String> get() = participants.map { "/${it.name}" }.distinct()

    /** Adds [participant], in front of one of the same name that is about to end. */
    fun add(participant: Participant) = participants.add(0, participant)

    /** Removes [participant], and its topics unless another has its name. */
    fun remove(participant: Participant) {
        participants -= participant
        if (participants.none { it.name == participant.name }) topics.removeBelow("/${participant.name}")
    }

    /**
     * Finds the action that a client means by the service or action [name].
     *
     * @throws RefusedRequest if there is none
     */
    fun target(name: String): Target {
        val parts = name.trim('/').split('/')
        val participant = participants.find { it.name == parts[0] }
        if (participant == null || parts.size < 2) {
            throw RefusedRequest("there is no $name; services are below ${nodes.joinToString(" and ").ifEmpty { "nothing yet" }}")
        }
        return Target(participant, parts.drop(1).joinToString("/"))
    }

    /** As [target], or null. */
    fun targetOrNull(name: String): Target? = try {
        target(name)
    } catch (_: RefusedRequest) {
        null
    }

    /** Returns the types of the known services, by their names. */
    fun services(): Map<String, String> = participants.distinctBy { it.name }.flatMap { participant ->
        val known = participant.actions.orEmpty().map { "/${participant.name}/${it.name}" to serviceType(it) }
        known + ("/${participant.name}/${Target.ACT}" to ACT_TYPE)
    }.toMap() + RosApiServices.TYPES

    /** Returns the known actions. */
    fun actions(): List<String> = participants.distinctBy { it.name }.flatMap { participant ->
        participant.actions.orEmpty().map { "/${participant.name}/${it.name}" }
    }

    private fun serviceType(action: BoardAction) = if (action.arguments == 0) TRIGGER_TYPE else COMMAND_TYPE

    companion object {
        const val TRIGGER_TYPE = "std_srvs/Trigger"

        /** A request `string[] arguments`, with the response of [TRIGGER_TYPE]. */
        const val COMMAND_TYPE = "argo_msgs/Command"

        /** A request `string command`, with the response of [TRIGGER_TYPE]. */
        const val ACT_TYPE = "argo_msgs/Act"
    }
}

/**
 * An action of a participant.
 *
 * @property action its name, with the namespace of its board in front if it has one: `left/stop`
 */
internal class Target(val participant: Participant, val action: String) {
    /** True unless the participant is known to lack it. */
    val mayExist: Boolean get() = participant.actions?.any { it.name == action } != false

    companion object {
        /** The service that takes any command, as text. */
        const val ACT = "act"
    }
}
