package experiment

import javino.LineSettings
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import samples.collision.Sensors

/**
 * The way in which agent and board work together.
 *
 * @property letter the condition's name on the command line and in records
 * @property sensing the agent's sensing policy
 * @property protocol the Javino version of the port, or null for the default
 */
@Serializable
internal enum class Condition(val letter: String, val title: String, val sensing: String, val protocol: String?) {
    /** As published: version 1, each reasoning cycle waits for the line, and commands are sent at once. */
    @SerialName("a")
    PUBLISHED("a", "as published", "in_cycle", "1"),

    @SerialName("b")
    DEFAULTS("b", "this project's defaults", "fresh", null),

    /** With version 2, the agent requests only percepts that its filter keeps. */
    @SerialName("c")
    VERSION_2("c", "version 2 with subscription", "fresh", "2"),

    /** [VERSION_2] with a critical rule that the board checks. The rule's reflex stops the robot at the limit. */
    @SerialName("d")
    REFLEX("d", "version 2, reflex on the board", "fresh", "2"),
    ;

    /** True for version 2, in which requests can name the kept percepts. */
    val isVersion2: Boolean get() = protocol == "2"
}

/** The percepts that the agent perceives. [word] is the view's name on the command line and in records. */
@Serializable
internal enum class View(val word: String) {
    /** The agent perceives all sensors. */
    @SerialName("none")
    NONE("none"),

    @SerialName("frontSide")
    FRONT_SIDE("frontSide"),

    @SerialName("frontDistance")
    FRONT_DISTANCE("frontDistance"),
    ;

    /** The functors of the kept percepts for version 2 requests, or null if all percepts are kept. */
    val functors: List<String>?
        get() = when (this) {
            NONE -> null
            FRONT_SIDE -> listOf("dist", "light", "temp")
            FRONT_DISTANCE -> listOf("dist")
        }

    /**
     * Returns the name of the agent's filter under [condition], for a stop at [limit] cm. The filter for version 2 is a keep filter.
     * Requests can then name the percepts.
     */
    fun filter(condition: Condition, limit: Int): String = when {
        condition == Condition.REFLEX -> reflexFilter(this, limit).name
        this == NONE -> "none"
        condition == Condition.VERSION_2 -> "keep" + word.replaceFirstChar(Char::uppercase)
        else -> word
    }
}

/**
 * One run: a combination of levels and the number of its replication.
 *
 * @property limit the front distance at which the agent stops, in cm
 * @property interval the sensing interval, in ms
 * @property replication the number of the replication, from 1
 * @property sensors the number of the robot's sensors, a multiple of twelve
 */
@Serializable
internal data class Trial(
    val condition: Condition,
    val view: View,
    val limit: Int,
    val interval: Int,
    val replication: Int,
    val baud: Int = LineSettings.DEFAULT_BAUD,
    val sensors: Int = Sensors.PER_SET,
) {
    /** The unique name of the run, its record and its board. */
    val id: String get() = "${condition.letter}-${view.word}-$limit-$interval-$replication" + if (isScaled) "-$sensors-$baud" else ""

    /** True if the run does not belong to the published design. */
    val isScaled: Boolean get() = baud != LineSettings.DEFAULT_BAUD || sensors != Sensors.PER_SET
}
