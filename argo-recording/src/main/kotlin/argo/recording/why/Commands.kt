package argo.recording.why

import argo.recording.CommandEnd
import argo.recording.Cycle
import argo.recording.ReflexEnd
import argo.recording.replay.Recording
import kotlin.math.abs

/** Finds all commands of one agent of [recording], from plans, reflexes and other senders. */
internal class Commands(
    private val recording: Recording,
    private val agent: String,
    private val cycles: List<Cycle>,
    private val clock: RecordingClock,
) {
    private val reflexOf = HashMap<RecordedCommand, ReflexEnd>()

    val all: List<RecordedCommand>

    init {
        val open = recording.reflexEnds(agent).toMutableList()
        val others = recording.commandEnds(agent).filter { it.text != null }.map { it to open.take(it) }.toList()
        val ordered = ofPlans() + others.map { (end, reflex) -> sent(end, reflex) to reflex } + open.map { reported(it) to it }
        all = ordered.sortedBy { (command, _) -> command.seconds }.mapIndexed { place, (command, reflex) ->
            command.copy(number = place + 1).also { if (reflex != null) reflexOf[it] = reflex }
        }
    }

    fun reflex(command: RecordedCommand): ReflexEnd? = reflexOf[command]

    private fun ofPlans(): List<Pair<RecordedCommand, ReflexEnd?>> = cycles.flatMap { cycle ->
        val seconds = clock.seconds(cycle.ns)
        val toBoards = cycle.input.calls.flatMap { it.commands }
            .map { RecordedCommand(agent, 0, it.text, it.port, seconds, cycle.number, sent = it.number, index = cycle.index) }
        val ofEnvironment = cycle.course.action?.let { RecordedCommand(agent, 0, it, null, seconds, cycle.number, index = cycle.index) }
        toBoards + listOfNotNull(ofEnvironment)
    }.map { it to null }

    private fun sent(end: CommandEnd, reflex: ReflexEnd?): RecordedCommand {
        val ns = end.issuedNs ?: end.ns
        val by = if (reflex == null) Sender.OUTSIDE else Sender.REFLEX
        return unplanned(end.text.orEmpty(), end.port, ns, by, end.number)
    }

    private fun reported(reflex: ReflexEnd) = unplanned(reflex.command, null, reflex.ns, Sender.REFLEX, null)

    private fun unplanned(text: String, port: String?, ns: Long, by: Sender, sent: Long?): RecordedCommand {
        val cycle = cycles.lastOrNull { it.ns <= ns }
        return RecordedCommand(agent, 0, text, port, clock.seconds(ns), cycle?.number ?: 0, by, sent, cycle?.index ?: 0)
    }

    /**
     * Removes and returns the reflex, sent by the computer, that has ended with [end]. The reflex and [end] were recorded within [SAME_NS]
     * ns of each other.
     */
    private fun MutableList<ReflexEnd>.take(end: CommandEnd): ReflexEnd? =
        filter { !it.isByBoard && it.command == end.text && abs(it.ns - end.ns) < SAME_NS }.minByOrNull { abs(it.ns - end.ns) }
            ?.also { remove(it) }

    private companion object {
        const val SAME_NS = 100_000_000L
    }
}

/**
 * Converts between ns of the agents' clock and seconds since the first cycle of a recording. [firstNs] is the beginning of the first cycle,
 * in ns of the agents' clock.
 */
internal class RecordingClock(private val firstNs: Long) {
    fun seconds(ns: Long): Double = (ns - firstNs) / NANOS

    fun nanos(seconds: Double): Long = firstNs + (seconds * NANOS).toLong()

    private companion object {
        const val NANOS = 1e9
    }
}
