package argo.ros.mapping

import argo.filters.Problem
import java.util.concurrent.TimeUnit

/** Maps a robot's topics, services and actions to percepts and commands; read from a file `NAME.ros.yaml`, the [source]. Immutable. */
internal class Mapping(val source: String, val percepts: List<PerceptRule>, val commands: List<CommandRule>)

/** A place in a mapping's file, line and column counted from 1. */
internal data class Place(val line: Int, val column: Int)

/**
 * A rule that makes percepts of a topic's messages: `/sonar/front sensor_msgs/Range -> dist(f, range*100) if range < max_range for 500 ms`.
 *
 * @property type the type of the topic's messages, as written
 * @property percept the literal, with fields of the message as arguments
 * @property conditions a message gives the percept if all of them hold
 * @property forMs the time in ms for which the percept holds; null: until the next message
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
 * A command, and the robot's message, request or goal for it: `move(V, W) -> /cmd_vel geometry_msgs/Twist(linear.x = V, angular.z = W)`.
 *
 * @property parameters the variables for the command's arguments
 * @property target the name of the topic, service or action
 * @property type the type of the topic's messages, the service or the action, as written
 * @property fields the fields of the message, request or goal, by their paths
 * @property withinMs the time that the outcome may take, in ms
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
    /** The way in which a command is carried out. [defaultMs] is its time limit in ms if the rule has none. */
    enum class Kind(val defaultMs: Long) {
        /** The subscribers of the topic act. The command ends when it has left. */
        TOPIC(TimeUnit.SECONDS.toMillis(5)),

        /** The command ends with the response. */
        SERVICE(TimeUnit.SECONDS.toMillis(5)),

        /** The command ends with the result. */
        ACTION(TimeUnit.SECONDS.toMillis(60)),
    }
}

/** A field of a message to send. [path] leads to it from the outside in. */
internal class FieldValue(val place: Place, val path: List<String>, val value: Expression)

/** A mapping's file was refused. The message contains all [problems], one a line. */
internal class MappingException(val problems: List<Problem>) : Exception(problems.joinToString("\n"))
