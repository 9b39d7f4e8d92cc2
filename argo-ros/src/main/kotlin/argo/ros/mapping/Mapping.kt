package argo.ros.mapping

import argo.filters.Problem
import java.util.concurrent.TimeUnit

/**
 * The percepts and commands for the topics, services and actions of a robot, from a file `NAME.ros.yaml`. Immutable.
 *
 * @property source the file
 */
internal class Mapping(val source: String, val percepts: List<PerceptRule>, val commands: List<CommandRule>) {
    /** The rules for the feedback of actions. */
    val feedback: List<PerceptRule> = commands.mapNotNull { it.feedback }

    /** The rules for the poses of frames. */
    val poses: List<PerceptRule> = percepts.filter { it.frames != null }

    /** Sentences about percepts that an agent cannot tell apart, that no message changes, or that are about one frame after the other. */
    val doubts: List<String>
        get() = percepts.groupBy { it.shape }.filterKeys { it != null }.values
            .filter { rules -> rules.size > 1 && rules.any { it.topic != rules[0].topic || it.condition == null } }.map(::alike) +
            percepts.filter { it.isConstant }.map(::constant) + percepts.filter { it.topic in Frames.TOPICS }.map(::ofAllFrames)

    private fun alike(rules: List<PerceptRule>): String {
        val percept = rules[0].percept
        return "$source: lines ${rules.joinToString(" and ") { "${it.place.line}" }} give percepts ${percept.functor}/" +
            "${percept.arguments.size} that an agent cannot tell apart; an atom in one of them would do, as ${percept.functor}(front, …)"
    }

    private fun constant(rule: PerceptRule) = "$source: line ${rule.place.line}: each message of ${rule.topic} gives the same percept " +
        "${rule.percept.functor}, which is believed for ever; a field in it, or behind it a condition, for 2 s or all, would change that"

    private fun ofAllFrames(rule: PerceptRule) = "$source: line ${rule.place.line}: one message of ${rule.topic} after the other is " +
        "about other frames; the pose of one is told by tf PARENT CHILD, as tf map base_link -> ${rule.percept.functor}(x, y, yaw)"
}

/** A place in a mapping's file, line and column counted from 1. */
internal data class Place(val line: Int, val column: Int)

/**
 * A rule that makes percepts of a topic's messages: `/sonar/front sensor_msgs/Range -> dist(f, range*100) if range < max_range for 500 ms`.
 *
 * @property type the type of the topic's messages, as written
 * @property percept the literal, with fields of the message as arguments
 * @property condition a message gives the percept if this condition holds; null: each message does
 * @property forMs the time in ms for which the percept holds; null: until the next message
 * @property frames the frames for a rule about a pose; null: the rule is about a topic. In a rule about a pose, [topic] is only a name
 * @property isOfEach whether each message is a separate event, so that none is left out; otherwise only the newest message counts
 */
internal class PerceptRule(
    val place: Place,
    val topic: String,
    val type: String,
    val percept: Expression.Compound,
    val condition: Expression?,
    val forMs: Int?,
    val isOfEach: Boolean = false,
    val frames: Frames? = null,
) {
    /** The percept's functor and constants, by which an agent distinguishes it from others; null: it has only constants. */
    val shape: List<Any?>?
        get() = percept.arguments.map { (it as? Expression.Constant)?.value }.takeIf { null in it }?.plus(percept.functor)

    /** True if all messages give the same percept, and the percept has no end. */
    val isConstant: Boolean
        get() = condition == null && forMs == null && !isOfEach && frames == null && percept.fields().isEmpty() &&
            Expression.AllFields !in percept.arguments

    /**
     * True if no message may be skipped: a message that meets the condition counts even if the next message, soon after it, does not meet
     * it.
     */
    val needsEach: Boolean get() = isOfEach || forMs != null && condition != null
}

/** The frames of a rule for the pose of [child] in [parent], which results from the transforms that all nodes publish. */
internal data class Frames(val parent: String, val child: String) {
    companion object {
        const val TYPE = "tf2_msgs/TFMessage"
        const val STATIC = "/tf_static"
        val TOPICS = listOf("/tf", STATIC)
    }
}

/**
 * A command, and the robot's message, request or goal for it: `move(V, W) -> /cmd_vel geometry_msgs/Twist(linear.x = V, angular.z = W)`.
 *
 * @property parameters the variables for the command's arguments
 * @property target the name of the topic, service or action
 * @property type the type of the topic's messages, the service or the action, as written
 * @property fields the fields of the message, request or goal, by their paths
 * @property hasFields whether the rule has brackets for fields, even empty ones
 * @property withinMs the time that the outcome may take, in ms
 * @property answer the answer to the agent, made of fields of the response or result; null: the list of all its fields
 * @property feedback the rule that makes percepts of an action's feedback while its goal is under way; null: none
 */
internal class CommandRule(
    val place: Place,
    val name: String,
    val parameters: List<String>,
    val kind: Kind,
    val target: String,
    val type: String,
    val fields: List<FieldValue>,
    val hasFields: Boolean,
    val withinMs: Int,
    val answer: Expression? = null,
    val feedback: PerceptRule? = null,
) {
    /** The way in which a command is carried out. [defaultMs] is its time limit in ms if the rule has none. */
    enum class Kind(val defaultMs: Long) {
        /** The subscribers of the topic act. The command ends when its message has left. */
        TOPIC(TimeUnit.SECONDS.toMillis(5)),

        /** The command ends with the response. */
        SERVICE(TimeUnit.SECONDS.toMillis(5)),

        /** The command ends with the result. */
        ACTION(TimeUnit.SECONDS.toMillis(60)),
    }
}

/** A field of a message that is sent, by its path from the outside in. */
internal class FieldValue(val place: Place, val path: List<String>, val value: Expression) {
    val steps: Path get() = path.map(Step::Name)
}

/** A mapping's file was refused. The message contains all [problems], one a line. */
internal class MappingException(val problems: List<Problem>) : Exception(problems.joinToString("\n"))
