package experiment.delegation

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The kinds of the robot's sensors, by the functors of their percepts. Each kind has a third of the sensors. */
internal val KINDS = listOf("dist", "light", "temp")

/**
 * How agents share the work: which of them sense, reason and act.
 *
 * @property word the design's name in records
 * @property boards the robot's boards, each with the kinds of its sensors; the first one has the motors
 */
@Serializable
internal enum class Design(val word: String, val title: String, val boards: List<List<String>>) {
    @SerialName("one")
    ONE("one", "one agent", listOf(KINDS)),

    /** Like [ONE], but with a board and a line for each kind of sensor, to show whether the lines or the agents make a difference. */
    @SerialName("boards")
    BOARDS("boards", "one agent, three boards", KINDS.map(::listOf)),

    /** An ARGO agent for each kind of sensor, each with a board, as the paper proposes in section 5.3. */
    @SerialName("kinds")
    KINDS_APART("kinds", "an agent for each kind", KINDS.map(::listOf)),

    /** An ARGO agent senses and acts. For each kind of sensor, a common agent reasons about the percepts that the ARGO agent sends it. */
    @SerialName("delegates")
    DELEGATES("delegates", "one agent delegates", listOf(KINDS)),
}
