package experiment.delegation

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The kinds of the robot's sensors, by the functors of their percepts. Each kind has a third of the sensors. */
internal val KINDS = listOf("dist", "light", "temp")

/**
 * A way to divide the work among agents: which of them sense, reason and act.
 *
 * @property word the design's name in records
 * @property boards the robot's boards, each with the kinds of its sensors. The first board has the motors
 */
@Serializable
internal enum class Design(val word: String, val title: String, val boards: List<List<String>>) {
    @SerialName("one")
    ONE("one", "one agent", listOf(KINDS)),

    /** [ONE] with a board and a line for each kind of sensor. The design separates the effect of lines from that of agents. */
    @SerialName("boards")
    BOARDS("boards", "one agent, three boards", KINDS.map(::listOf)),

    /** An ARGO agent with a board for each kind of sensor, as the paper proposes in section 5.3. */
    @SerialName("kinds")
    KINDS_APART("kinds", "an agent for each kind", KINDS.map(::listOf)),

    /** An ARGO agent senses and acts, and sends its percepts to common agents. Each common agent reasons about one kind of sensor. */
    @SerialName("delegates")
    DELEGATES("delegates", "one agent delegates", listOf(KINDS)),
}
