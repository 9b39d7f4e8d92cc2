package argo.ros.mapping

import argo.filters.Problem
import java.util.concurrent.TimeUnit

/**
 * The percepts and commands of a robot, from a file `NAME.ros.yaml`. Immutable.
 *
 * @property source the file
 */
internal class Mapping(val source: String, val percepts: List<PerceptRule>, val commands: List<CommandRule>) {
    val feedback: List<PerceptRule> = commands.mapNotNull { it.feedback }

    val poses: List<PerceptRule> = percepts.filter { it.frames != null }

    /** Warnings about doubtful rules: two percepts look alike, no message changes a percept, or the messages are about different frames. */
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

/** A place in a mapping file. Line and column count from 1. */
internal data class Place(val line: Int, val column: Int)

/**
 * A rule that turns a topic's messages into percepts:
 * `/sonar/front sensor_msgs/Range -> dist(f, range*100) if range < max_range for 500 ms`.
 *
 * @property type the message type, as written
 * @property percept the literal, with message fields as arguments
 * @property condition only messages that meet this condition give the percept; null means all messages
 * @property forMs the time in ms for which the percept holds, or null if it holds until the next message
 * @property frames the frames of a pose rule, or null for a topic rule. In a pose rule, [topic] is only a name
 * @property isOfEach true if each message is a separate event; false if only the newest message counts
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
    /** The functor and constants by which an agent distinguishes the percept from others, or null if the percept has only constants. */
    val shape: List<Any?>?
        get() = percept.arguments.map { (it as? Expression.Constant)?.value }.takeIf { null in it }?.plus(percept.functor)

    /** True if all messages give the same percept, and the percept never ends. */
    val isConstant: Boolean
        get() = condition == null && forMs == null && !isOfEach && frames == null && percept.fields().isEmpty() &&
            Expression.AllFields !in percept.arguments

    /**
     * True if no message may be skipped. With a condition and a time, a message counts even if the next one does not meet the condition.
     */
    val needsEach: Boolean get() = isOfEach || forMs != null && condition != null
}

/** The frames of a rule for the pose of [child] in [parent]. The transforms of all nodes determine the pose. */
internal data class Frames(val parent: String, val child: String) {
    companion object {
        const val TYPE = "tf2_msgs/TFMessage"
        const val STATIC = "/tf_static"
        val TOPICS = listOf("/tf", STATIC)
    }
}

/**
 * A command, and the message, request or goal that it sends: `move(V, W) -> /cmd_vel geometry_msgs/Twist(linear.x = V, angular.z = W)`.
 *
 * @property parameters the variables for the command's arguments
 * @property target the name of the topic, service or action
 * @property type the message type, the service type or the action type, as written
 * @property fields the fields to set, with their paths
 * @property hasFields true if the rule has parentheses for fields, even empty ones
 * @property withinMs the time limit for the outcome, in ms
 * @property answer the answer to the agent, made of fields of the response or result, or null for a list of all fields
 * @property feedback the rule that makes percepts of an action's feedback, or null if there is none
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
    /** The way in which a command is carried out. [defaultMs] is the time limit in ms for rules without one. */
    enum class Kind(val defaultMs: Long) {
        /** The command publishes a message. The command ends when the message was sent. */
        TOPIC(TimeUnit.SECONDS.toMillis(5)),

        /** The command calls a service. The command ends with the response. */
        SERVICE(TimeUnit.SECONDS.toMillis(5)),

        /** The command sends a goal to an action server. The command ends with the result. */
        ACTION(TimeUnit.SECONDS.toMillis(60)),
    }
}

/** A field of a message to send. The path starts at the outermost field. */
internal class FieldValue(val place: Place, val path: List<String>, val value: Expression) {
    val steps: Path get() = path.map(Step::Name)
}

/** A mapping file is refused. The message contains all [problems], one on each line. */
internal class MappingException(val problems: List<Problem>) : Exception(problems.joinToString("\n"))
