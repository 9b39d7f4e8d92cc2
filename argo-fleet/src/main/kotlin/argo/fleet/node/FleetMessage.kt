package argo.fleet.node

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json

/** A message from one computer of a fleet to another. The bytes of a message are [FORMAT] and then JSON. */
@Serializable
internal sealed interface FleetMessage {
    fun encode(): ByteArray = byteArrayOf(FORMAT) + JSON.encodeToString(serializer(), this).encodeToByteArray()

    companion object {
        /** The first byte of each message. Another format may use the JSON names for other things. */
        const val FORMAT: Byte = 1
        private val JSON = Json { encodeDefaults = false }

        /** Reads a message. @throws UnreadableMessage if [bytes] are no message */
        fun decode(bytes: ByteArray): FleetMessage {
            val format = bytes.firstOrNull()
            if (format != FORMAT) throw UnreadableMessage("it is of format $format, and this version of ARGO knows format $FORMAT only")
            try {
                return JSON.decodeFromString(serializer(), bytes.decodeToString(1, bytes.size, throwOnInvalidSequence = true))
            } catch (unreadable: SerializationException) {
                throw UnreadableMessage("it is no message of a fleet: ${unreadable.message?.lineSequence()?.first()}")
            } catch (_: CharacterCodingException) {
                throw UnreadableMessage("it is no text")
            }
        }
    }
}

/** The bytes from another computer are no message of this version; [message] gives the reason. */
internal class UnreadableMessage(override val message: String) : Exception(message)

/**
 * A message from one agent to another.
 *
 * @property force the performative, such as `tell`
 * @property content the text of the content, as in [argo.recording.agent.MessageContent]
 * @property term the term of the sender's [Reign], or 0 if the sender does not outlive its computer
 */
@Serializable
@SerialName("say")
internal data class Say(
    val id: String?,
    val inReplyTo: String? = null,
    val force: String,
    val from: String,
    val to: String,
    val content: String,
    val term: Long = 0,
) : FleetMessage

/** The answer to [question] of the agent [to] will not arrive, because of [error] and [reason]. */
@Serializable
@SerialName("unanswered")
internal data class Unanswered(val question: String, val to: String, val error: String, val reason: String) : FleetMessage

/** A service that [agent] has registered by `.df_register`. */
@Serializable
internal data class Offer(val agent: String, val service: String)

/**
 * The agents and services of the sending computer.
 *
 * @property isWhole true for all agents and services; false for the changes since the last roster
 * @property unable the agents that outlive their computers and that the sender cannot start
 * @property able the agents that were unable, and that the sender will try to start again
 * @property asksBack true if the sender lacks the receiver's roster. The receiver must then send it
 */
@Serializable
@SerialName("roster")
internal data class RosterNews(
    val isWhole: Boolean = false,
    val came: Set<String> = emptySet(),
    val gone: Set<String> = emptySet(),
    val offered: Set<Offer> = emptySet(),
    val withdrawn: Set<Offer> = emptySet(),
    val unable: Set<String> = emptySet(),
    val able: Set<String> = emptySet(),
    val asksBack: Boolean = false,
) : FleetMessage

/**
 * The rosters that the sender knows. A receiver that has missed news detects it by them.
 *
 * @property digests the [Roster.digest] of each computer that is in touch with the sender and has reported its roster
 */
@Serializable
@SerialName("known")
internal data class Known(val digests: Map<String, Int>) : FleetMessage

/** The agent [by] kills [agent], which has [deadlineMs] ms to end. */
@Serializable
@SerialName("kill")
internal data class Kill(val agent: String, val by: String, val deadlineMs: Int) : FleetMessage

/** An agent has called `.stopMAS` with these arguments. */
@Serializable
@SerialName("stop")
internal data class Stop(val deadlineMs: Int, val stopsJvm: Boolean, val exitStatus: Int) : FleetMessage

/**
 * The sender wants to run [agent], which outlives its computer, or to continue it. Each claim has a greater [number].
 *
 * @property mindTerm the [MindNews.term] of the newest mind of [agent] that the sender knows, or 0 for none
 * @property mindNumber the [MindNews.number] of that mind
 */
@Serializable
@SerialName("claim")
internal data class Claim(
    val agent: String,
    val number: Long,
    val term: Long,
    val mindTerm: Long = 0,
    val mindNumber: Long = 0,
) : FleetMessage

/**
 * The answer to a [Claim]. With a grant, a computer promises to grant no other computer's claim for some time.
 *
 * @property term the greatest term of a reign over [agent] that the sender knows
 */
@Serializable
@SerialName("grant")
internal data class Grant(val agent: String, val number: Long, val term: Long, val isGranted: Boolean) : FleetMessage

/** The beliefs and goals of [agent], an agent that outlives its computer, as AgentSpeak. */
@Serializable
@SerialName("mind")
internal data class MindNews(val agent: String, val term: Long, val number: Long, val program: String) : FleetMessage {
    /** Returns true if this mind is newer than the one with [term] and [number]. */
    fun isNewerThan(term: Long, number: Long) = if (this.term == term) this.number > number else this.term > term
}
