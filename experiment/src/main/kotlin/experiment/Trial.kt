package experiment

import javino.LineSettings
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import samples.collision.Sensors

/**
 * How agent and board work together in a run.
 *
 * @property letter the condition's name on the command line and in records
 * @property sensing the agent's sensing policy
 * @property protocol the version of Javino for the port; null: the default
 */
@Serializable
internal enum class Condition(val letter: String, val title: String, val sensing: String, val protocol: String?) {
    /** The published setting: each reasoning cycle waits for the line, commands are written at once, version 1. */
    @SerialName("a")
    PUBLISHED("a", "as published", "in_cycle", "1"),

    @SerialName("b")
    DEFAULTS("b", "this project's defaults", "fresh", null),

    /** The board speaks version 2, so the agent can request only the percepts that its filter keeps. */
    @SerialName("c")
    VERSION_2("c", "version 2 with subscription", "fresh", "2"),

    /** Like [VERSION_2], but the board watches a critical rule at the limit, and the rule's reflex stops the robot. */
    @SerialName("d")
    REFLEX("d", "version 2, reflex on the board", "fresh", "2"),
    ;

    /** True if agent and board speak version 2, so that requests can name the percepts that the filter keeps. */
    val isVersion2: Boolean get() = protocol == "2"
}

/** The part of the percepts that the agent perceives. [word] is the view's name on the command line and in records. */
@Serializable
internal enum class View(val word: String) {
    /** The agent perceives all sensors. */
    @SerialName("none")
    NONE("none"),

    /** The front sensors of the three kinds. */
    @SerialName("frontSide")
    FRONT_SIDE("frontSide"),

    /** The front distance sensor. */
    @SerialName("frontDistance")
    FRONT_DISTANCE("frontDistance"),
    ;

    /** The functors of the kept percepts, for requests to a board of version 2; null: all percepts are kept. */
    val functors: List<String>?
        get() = when (this) {
            NONE -> null
            FRONT_SIDE -> listOf("dist", "light", "temp")
            FRONT_DISTANCE -> listOf("dist")
        }

    /**
     * Returns the name of the agent's filter under [condition], for stopping at [limit] cm. For version 2 it is a keep filter, so that
     * requests can name the percepts.
     */
    fun filter(condition: Condition, limit: Int): String = when {
        condition == Condition.REFLEX -> reflexFilter(this, limit).name
        this == NONE -> "none"
        condition == Condition.VERSION_2 -> "keep" + word.replaceFirstChar(Char::uppercase)
        else -> word
    }
}

/**
 * One run: a combination of the experiment's levels, and the number of its replication.
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
    /** The name of the run's record and of its board. Each run of an experiment has another name. */
    val id: String get() = "${condition.letter}-${view.word}-$limit-$interval-$replication" + if (isScaled) "-$sensors-$baud" else ""

    /** Whether the run is beyond the published design. */
    val isScaled: Boolean get() = baud != LineSettings.DEFAULT_BAUD || sensors != Sensors.PER_SET
}
