package argo.recording.replay

import argo.recording.Cycle
import argo.recording.Mail
import java.util.ArrayDeque
import kotlin.math.abs

/**
 * Finds the messages that agents of several [recordings], such as those of a fleet's computers, sent to each other. Computes the
 * differences of the recordings' clocks from the messages. Messages are found by sender and name. For one thread.
 */
class JointRecordings(private val recordings: List<Recording>) {
    /**
     * A message that was sent.
     *
     * @property recording the index of the sender's recording
     * @property cycle the sender's cycle
     */
    class Sending(val recording: Int, val agent: String, val cycle: Cycle, val mail: Mail)

    private class Telling(val place: Int, val agent: String, val cycle: Cycle)

    /** The cycles in which agents sent or took messages. */
    private val telling: List<Telling> = recordings.flatMapIndexed { place, recording ->
        recording.agents.keys.flatMap { agent ->
            recording.cycles(agent).filter { it.course.mail.isNotEmpty() || it.input.mail.isNotEmpty() }.map { Telling(place, agent, it) }
        }
    }

    private val sent: Map<Pair<String, String>, List<Sending>> = telling.flatMap(::sendings).groupBy { it.agent to it.mail.id }

    private val differences: Map<Pair<Int, Int>, List<Long>> by lazy { messageTimes() }

    /** For each recording, the difference of its clock from the first recording's clock; null if no messages connect the two. */
    val differencesOfClocks: List<ClockDifference?> by lazy { ofAll() }

    private fun sendings(one: Telling) =
        one.cycle.course.mail.filter { it.failure == null }.map { Sending(one.place, one.agent, one.cycle, it) }

    /** Returns the sending of [mail], which the agent [receiver] of the recording [place] took; null if it was not recorded. */
    fun sending(place: Int, receiver: String, mail: Mail): Sending? {
        val own = mail.sender in recordings[place].agents
        return sent[mail.sender to mail.id]?.find { one ->
            one.mail.performative == mail.performative && one.mail.receiver in setOf(receiver, EVERYBODY) && (one.recording == place) == own
        }
    }

    /** Returns the times of the messages between each pair of recordings: the receiver's time minus the sender's time, in ns. */
    private fun messageTimes(): Map<Pair<Int, Int>, List<Long>> = telling.flatMap { one ->
        one.cycle.input.mail.mapNotNull { sending(one.place, one.agent, it) }.filter { it.recording != one.place }
            .map { (it.recording to one.place) to one.cycle.ns - it.cycle.ns }
    }.groupBy({ it.first }, { it.second })

    private fun ofAll(): List<ClockDifference?> {
        val known = HashMap(mapOf(0 to ClockDifference.NONE))
        val open = ArrayDeque(listOf(0))
        while (open.isNotEmpty()) {
            val from = open.remove()
            for (to in recordings.indices) if (to !in known) between(from, to)?.let {
                known[to] = known.getValue(from) + it
                open += to
            }
        }
        return recordings.indices.map(known::get)
    }

    private fun between(from: Int, to: Int) = ClockDifference.of(differences[from to to].orEmpty(), differences[to to from].orEmpty())

    private companion object {
        const val EVERYBODY = "everybody"
    }
}

/**
 * The time by which a recording's clock is ahead of another recording's clock.
 *
 * @property ns the difference in ns
 * @property withinNs the largest error of [ns], in ns; null if it is not known, since messages went only one way
 * @property messages the number of messages that show the difference
 */
data class ClockDifference(val ns: Long, val withinNs: Long?, val messages: Int) {
    internal operator fun plus(next: ClockDifference) =
        ClockDifference(ns + next.ns, withinNs?.let { one -> next.withinNs?.let { one + it } }, messages + next.messages)

    companion object {
        val NONE = ClockDifference(0, 0, 0)

        /**
         * Returns the time by which the receiver's clock is ahead of the sender's; null if there are no messages. [there] has one number
         * for each message: its arrival by the receiver's clock minus its sending by the sender's clock, in ns. [back] has these numbers
         * for messages in the other direction. Messages take time, so [there] gives an upper limit, and [back] a lower one.
         */
        internal fun of(there: List<Long>, back: List<Long>): ClockDifference? {
            val (most, least) = there.minOrNull() to back.minOrNull()?.unaryMinus()
            val messages = there.size + back.size
            if (most != null && least != null) return ClockDifference((most + least) / 2, (most - least) / 2, messages)
            return (most ?: least)?.let { ClockDifference(it, null, messages) }
        }
    }

    /** The difference in words: `1.250 s ahead, give or take 0.4 ms, by 12 messages`. */
    override fun toString(): String {
        val accuracy = withinNs?.let { "give or take %.1f ms".format(it / 1e6) } ?: "but for the time that a message takes"
        val number = if (messages == 1) "one message" else "$messages messages"
        return "%.3f s %s, %s, by %s".format(abs(ns) / 1e9, if (ns < 0) "behind" else "ahead", accuracy, number)
    }
}
