package experiment.delegation

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The kinds of the robot's sensors, by the functors of their percepts. A third of the sensors is of each kind. */
internal val KINDS = listOf("dist", "light", "temp")

/**
 * The share of work among agents: who senses, who reasons, and who acts.
 *
 * @property word the design's name in records
 * @property boards the robot's boards, each with the kinds of its sensors; the first one has the motors
 */
@Serializable
internal enum class Design(val word: String, val title: String, val boards: List<List<String>>) {
    @SerialName("one")
    ONE("one", "one agent", listOf(KINDS)),

    /** Like [ONE], with a line for each kind of sensor. This design shows whether the lines or the agents make a difference. */
    @SerialName("boards")
    BOARDS("boards", "one agent, three boards", KINDS.map(::listOf)),

    /** An ARGO agent for each kind of sensor, each with a board, as the paper proposes in section 5.3. */
    @SerialName("kinds")
    KINDS_APART("kinds", "an agent for each kind", KINDS.map(::listOf)),

    /** An ARGO agent that senses and acts, and for each kind of sensor a common agent that reasons about what the first one tells it. */
    @SerialName("delegates")
    DELEGATES("delegates", "one agent delegates", listOf(KINDS)),
}
