package argo.view

import argo.observing.CommandFailure
import argo.observing.IssuedCommand
import java.util.concurrent.TimeUnit

/** The commands of an agent: those that have not gone out, and the last ones that have. Not safe for use by several threads. */
internal class CommandRecord {
    private val unfinished = LinkedHashMap<Long, IssuedCommand>()
    private val finished = ArrayDeque<Ended>()
    private var issued = 0L

    /** How many have gone out or failed. */
    var count = 0L
        private set

    /** Notes that [command] waits to be sent. */
    fun issued(command: IssuedCommand) {
        issued++
        if (unfinished.size < MAX_UNFINISHED) unfinished[command.number] = command
    }

    /** Notes how [command] has ended, at [nanos]. */
    fun ended(command: IssuedCommand, failure: CommandFailure?, nanos: Long) {
        count++
        unfinished -= command.number
        if (finished.size == MAX_FINISHED) finished.removeLast()
        finished.addFirst(Ended(command, nanos, failure))
    }

    /** All that is known at [now]. The oldest of each port is taken to be on the line, since only urgent commands overtake others. */
    fun state(now: Long): CommandsState {
        val ports = HashSet<String>()
        val waiting = unfinished.values.map { it.state(now, if (ports.add(it.port)) "line" else "waiting") }
        val ended = finished.map { it.command.state(now, if (it.failure == null) "done" else "failed", it) }
        return CommandsState((issued - count).toInt(), waiting, ended)
    }

    private fun IssuedCommand.state(now: Long, state: String, end: Ended? = null) = CommandState(
        number, port, shown(text), state, ms(now - issuedNanos), end?.let { ms(it.nanos - issuedNanos) },
        end?.failure?.let { shown("${it.error}: ${it.cause}") },
    )

    private class Ended(val command: IssuedCommand, val nanos: Long, val failure: CommandFailure?)

    private companion object {
        const val MAX_UNFINISHED = 50
        const val MAX_FINISHED = 30
    }
}

/** [nanos] ns in whole ms, never below 0. */
internal fun ms(nanos: Long): Long = maxOf(0, TimeUnit.NANOSECONDS.toMillis(nanos))
