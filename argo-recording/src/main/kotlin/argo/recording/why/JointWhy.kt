package argo.recording.why

import argo.recording.replay.JointRecordings
import argo.recording.replay.Recording
import argo.recording.replay.RecordingException

/**
 * Follows messages from recordings of receivers into recordings of senders, such as those of a fleet's computers.
 *
 * Close the object at the end. For one thread.
 *
 * @param recordings the recordings by their names; questions are about the first one
 */
class JointWhy(private val recordings: Map<String, Recording>) : AutoCloseable {
    private val names = recordings.keys.toList()
    private val whys = recordings.values.map { lazy { Why(it) } } // lazy, since each reads a whole recording
    private val joint by lazy { JointRecordings(recordings.values.toList()) }

    /** Explains the commands of the first recording. */
    val first: Why get() = whys.first().value

    /** Returns the [answer] that [first] has given, together with the sendings of the messages that led to the answer's root. */
    fun follow(answer: Answer): Answer = answer.copy(sent = sendings(0, answer.command.agent, answer.cause))

    private fun sendings(place: Int, agent: String, cause: Cause?): List<SentCause> {
        val found = ArrayList<SentCause>()
        var (at, receiver) = place to agent
        var root = cause?.root() as? MessageCause
        while (root != null && found.size < MOST_FOLLOWED) {
            val sending = whys[at].value.mailOf(receiver, root)?.let { joint.sending(at, receiver, it) } ?: break
            found += sent(sending, at, whys[at].value.nanos(root.seconds))
            root = found.last().cause?.root() as? MessageCause
            at = sending.recording
            receiver = sending.agent
        }
        return found
    }

    private fun sent(sending: JointRecordings.Sending, receiver: Int, takenNs: Long): SentCause {
        val own = whys[sending.recording].value
        val differences = joint.differencesOfClocks
        val (here, there) = differences[receiver] to differences[sending.recording]
        val delay = if (here == null || there == null) null else (takenNs - here.ns) - (sending.cycle.ns - there.ns)
        val step = runCatching { own.sending(sending.agent, sending.cycle, sending.mail.id) }
        val refused = step.exceptionOrNull()
        if (refused != null && refused !is RecordingException) throw refused
        return SentCause(
            names[sending.recording], sending.agent, own.seconds(sending.cycle.ns), delay?.let { it / NANOS_PER_MS },
            there?.takeIf { sending.recording != 0 }?.toString(), step.getOrNull(),
            refused?.message ?: "the replay did not see the step".takeIf { step.getOrNull() == null },
        )
    }

    override fun close() = whys.filter { it.isInitialized() }.forEach { it.value.close() }

    private companion object {
        const val MOST_FOLLOWED = 20
        const val NANOS_PER_MS = 1e6
    }
}
