package argo.view

import argo.observing.CommandFailure
import argo.observing.IssuedCommand
import java.util.concurrent.TimeUnit

/**
 * An agent's commands: all that have not gone out, and the last of the others. Equal commands in a row with equal outcomes become one
 * command with a count. Not safe for use by several threads.
 */
internal class CommandRecord {
    private val unfinished = LinkedHashMap<Long, IssuedCommand>()
    private val finished = ArrayDeque<Ended>()
    private var issued = 0L

    /** The number of commands that have gone out or failed. */
    var count = 0L
        private set

    /** Notes that [command] waits to be sent. */
    fun issued(command: IssuedCommand) {
        issued++
        if (unfinished.size < MAX_UNFINISHED) unfinished[command.number] = command
    }

    fun ended(command: IssuedCommand, failure: CommandFailure?, nanos: Long) {
        count++
        unfinished -= command.number
        val last = finished.firstOrNull()
        if (last != null && last.isAlike(command, failure)) {
            last.again(command, nanos)
            return
        }
        if (finished.size == MAX_FINISHED) finished.removeLast()
        finished.addFirst(Ended(command, nanos, failure))
    }

    /** Returns the commands at [now]. The oldest command of a port counts as on the line, since only urgent commands overtake others. */
    fun state(now: Long): CommandsState {
        val ports = HashSet<String>()
        val waiting = unfinished.values.map { it.state(now, if (ports.add(it.port)) "line" else "waiting") }
        return CommandsState((issued - count).toInt(), folded(waiting), finished.map { it.state(now) })
    }

    /** Replaces equal commands in a row by the first of them with a count. */
    private fun folded(commands: List<CommandState>): List<CommandState> = commands.fold(emptyList()) { folded, next ->
        val last = folded.lastOrNull()
        if (last == null || last.text != next.text || last.port != next.port || last.state != next.state) folded + next
        else folded.dropLast(1) + last.copy(times = last.times + 1, last = next.number)
    }

    private fun IssuedCommand.state(now: Long, state: String) =
        CommandState(number, port, shown(text), 1, state, ms(now - issuedNanos), tookMs = null, error = null, last = number)

    private class Ended(private var command: IssuedCommand, private var nanos: Long, private val failure: CommandFailure?) {
        private val first = command.number
        private var times = 1

        fun isAlike(other: IssuedCommand, otherFailure: CommandFailure?) = command.text == other.text && command.port == other.port &&
            failure?.error == otherFailure?.error && failure?.cause == otherFailure?.cause

        fun again(command: IssuedCommand, nanos: Long) {
            this.command = command
            this.nanos = nanos
            times++
        }

        fun state(now: Long) = CommandState(
            first, command.port, shown(command.text), times, if (failure == null) "done" else "failed", ms(now - command.issuedNanos),
            ms(nanos - command.issuedNanos), failure?.let { shown("${it.error}: ${it.cause}") }, command.number,
        )
    }

    private companion object {
        const val MAX_UNFINISHED = 50
        const val MAX_FINISHED = 30
    }
}

/** Returns [nanos] ns in whole ms, never below 0. */
internal fun ms(nanos: Long): Long = maxOf(0, TimeUnit.NANOSECONDS.toMillis(nanos))
