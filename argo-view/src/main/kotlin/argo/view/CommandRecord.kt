package argo.view

import argo.observing.CommandFailure
import argo.observing.IssuedCommand
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The commands of an agent: those that have not gone out, and the last ones that have. Safe for use by several threads; nothing takes
 * longer than a note.
 *
 * @param nanos a clock in ns that never goes back
 */
internal class CommandRecord(private val nanos: () -> Long) {
    private val lock = ReentrantLock()
    private val unfinished = LinkedHashMap<Long, IssuedCommand>()
    private val finished = ArrayDeque<Ended>()
    private var issued = 0L
    private var done = 0L

    /** How many have gone out or failed. */
    val count: Long get() = lock.withLock { done }

    /** Notes that [command] waits to be sent. */
    fun issued(command: IssuedCommand) = lock.withLock {
        issued++
        if (unfinished.size < MAX_UNFINISHED) unfinished[command.number] = command
    }

    /** Notes how [command] has ended. */
    fun ended(command: IssuedCommand, failure: CommandFailure?) = lock.withLock {
        done++
        unfinished -= command.number
        if (finished.size == MAX_FINISHED) finished.removeLast()
        finished.addFirst(Ended(command, nanos(), failure))
    }

    /** All that is known at [now]. The oldest of each port is taken to be on the line, since all but urgent commands go out in their order. */
    fun state(now: Long): CommandsState = lock.withLock {
        val ports = HashSet<String>()
        val waiting = unfinished.values.map { it.state(now, if (ports.add(it.port)) "line" else "waiting") }
        CommandsState((issued - done).toInt(), waiting, finished.map { it.command.state(now, if (it.failure == null) "done" else "failed", it) })
    }

    private fun IssuedCommand.state(now: Long, word: String, end: Ended? = null) = CommandState(
        number, port, shown(text), word, ms(now - issuedNanos), end?.let { ms(it.nanos - issuedNanos) },
        end?.failure?.let { shown("${it.error}: ${it.cause}") },
    )

    private class Ended(val command: IssuedCommand, val nanos: Long, val failure: CommandFailure?)

    private companion object {
        const val MAX_UNFINISHED = 50
        const val MAX_FINISHED = 30
    }
}

/** [nanos] ns in whole ms, never below 0. */
internal fun ms(nanos: Long): Long = maxOf(0, nanos / 1_000_000)
