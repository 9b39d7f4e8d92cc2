package argo.view

import argo.calls.Failure
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
    private val unfinished = LinkedHashMap<Long, Entry>()
    private val finished = ArrayDeque<Entry>()
    private var issued = 0L
    private var done = 0L

    /** How many have gone out or failed. */
    val count: Long get() = lock.withLock { done }

    /** Notes that [text] is to be sent to the board on [port]; the result takes how that ended. */
    fun issue(port: String, text: String): (Failure?) -> Unit = lock.withLock {
        val entry = Entry(++issued, port, shown(text), nanos())
        if (unfinished.size < MOST_UNFINISHED) unfinished[entry.number] = entry
        return { finish(entry, it) }
    }

    private fun finish(entry: Entry, failure: Failure?) = lock.withLock {
        done++
        unfinished -= entry.number
        if (finished.size == MOST_FINISHED) finished.removeLast()
        finished.addFirst(entry.copy(doneNanos = nanos(), failure = failure))
    }

    /** All that is known at [now]. The oldest of each port is taken to be on the line, since all but urgent commands go out in their order. */
    fun state(now: Long): CommandsState = lock.withLock {
        val ports = HashSet<String>()
        val waiting = unfinished.values.map { it.state(now, if (ports.add(it.port)) "line" else "waiting") }
        CommandsState((issued - done).toInt(), waiting, finished.map { it.state(now, if (it.failure == null) "done" else "failed") })
    }

    private data class Entry(
        val number: Long,
        val port: String,
        val text: String,
        val issuedNanos: Long,
        val doneNanos: Long? = null,
        val failure: Failure? = null,
    ) {
        fun state(now: Long, word: String) = CommandState(
            number, port, text, word, ms(now - issuedNanos), doneNanos?.let { ms(it - issuedNanos) },
            failure?.let { shown("${it.error}: ${it.cause}") },
        )
    }

    private companion object {
        const val MOST_UNFINISHED = 50
        const val MOST_FINISHED = 30
    }
}

/** [nanos] ns in whole ms, never below 0. */
internal fun ms(nanos: Long): Long = maxOf(0, nanos / 1_000_000)
