package argo.ros.mapping

import argo.filters.Problem
import java.util.concurrent.TimeUnit

/**
 * What the topics, services and actions of a robot are to an agent, as a file `NAME.ros.yaml` says. Does not change.
 *
 * @property source the file
 */
internal class Mapping(val source: String, val percepts: List<PerceptRule>, val commands: List<CommandRule>)

/** Where in its file something stands, both counted from 1. */
internal data class Place(val line: Int, val column: Int)

/**
 * A percept that the messages of a topic become: `/sonar/front sensor_msgs/Range -> dist(f, range*100) if range < max_range for 500 ms`.
 *
 * @property topic its name
 * @property type the type of its messages, as it is written
 * @property percept the literal, with fields of the message for its arguments
 * @property conditions all of them hold for a message that has this percept
 * @property forMs for how many ms a message has it; null: until the next message
 */
internal class PerceptRule(
    val place: Place,
    val topic: String,
    val type: String,
    val percept: Expression.Compound,
    val conditions: List<Comparison>,
    val forMs: Int?,
)

/**
 * A command, and what a robot does for it: `move(V, W) -> /cmd_vel geometry_msgs/Twist(linear.x = V, angular.z = W)`.
 *
 * @property name its functor
 * @property parameters the variables for its arguments
 * @property kind what [target] is
 * @property target the name of the topic, service or action
 * @property type of the topic's messages, the service or the action, as it is written
 * @property fields what the message, request or goal has in it, by the path of the field
 * @property withinMs how long the outcome may take, in ms
 */
internal class CommandRule(
    val place: Place,
    val name: String,
    val parameters: List<String>,
    val kind: Kind,
    val target: String,
    val type: String,
    val fields: List<FieldValue>,
    val withinMs: Int,
) {
    /** What carries a command out, and how long that may take in ms unless its rule has a time. */
    enum class Kind(val defaultMs: Long) {
        /** Whoever subscribes; the command is over when it has left. */
        TOPIC(TimeUnit.SECONDS.toMillis(5)),

        /** The command is over with the response. */
        SERVICE(TimeUnit.SECONDS.toMillis(5)),

        /** The command is over with the result. */
        ACTION(TimeUnit.SECONDS.toMillis(60)),
    }
}

/** A field of a message that is sent, by its path from the outside in. */
internal class FieldValue(val place: Place, val path: List<String>, val value: Expression)

/** A file that says what a robot's topics are was refused. The message has all [problems], one a line. */
internal class MappingException(val problems: List<Problem>) : Exception(problems.joinToString("\n"))
