package argo.platform

import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Prevents repeated events from filling a log. The first [FREE] lines of a kind are written at once. Further lines of the kind are thinned
 * out: the newest is written at growing intervals, from a second to five minutes, with the number of left-out lines. The last line of a
 * kind always appears. If a kind has no line for a minute, it counts as new. Safe for use by several threads.
 *
 * @param nowMs a clock in ms that never goes back
 * @param later calls `action` after `delayMs` ms
 */
class ThinnedLog(private val nowMs: () -> Long, private val later: (delayMs: Long, action: () -> Unit) -> Unit) {
    private class Kind {
        var told = 0
        var lastMs = 0L
        var delayMs = FIRST_DELAY_MS
        var held = 0
        var newest: ((String) -> Unit)? = null
    }

    private val lock = ReentrantLock()
    private val kinds = HashMap<String, Kind>()

    /**
     * Reports a line of [kind]. Use few kinds, since each is kept.
     *
     * @param line writes the line, followed by `more`. Called at most once, now or later. Not called if a newer line replaces this one
     */
    fun report(kind: String, line: (more: String) -> Unit) {
        var delayMs = 0L
        val isNow = lock.withLock {
            val now = nowMs()
            val state = kinds[kind]?.takeIf { it.held > 0 || now - it.lastMs <= QUIET_MS } ?: Kind().also { kinds[kind] = it }
            state.lastMs = now
            (state.told++ < FREE).also { if (!it) delayMs = hold(state, line) }
        }
        if (isNow) line("") else if (delayMs > 0) later(delayMs) { tell(kind) }
    }

    /** Returns the ms after which the newest line must be written; 0 if an earlier call has returned this time. */
    private fun hold(kind: Kind, line: (String) -> Unit): Long {
        kind.newest = line
        if (kind.held++ > 0) return 0
        return kind.delayMs.also { kind.delayMs = minOf(2 * it, MAX_DELAY_MS) }
    }

    private fun tell(name: String) {
        val (line, count) = lock.withLock {
            val kind = kinds.getValue(name)
            (kind.newest to kind.held).also {
                kind.newest = null
                kind.held = 0
            }
        }
        line?.invoke(if (count > 1) " (and ${count - 1} more like this before)" else "")
    }

    companion object {
        /** The number of lines of a kind that are written at once. */
        const val FREE = 10
        private const val FIRST_DELAY_MS = 1_000L
        private const val MAX_DELAY_MS = 300_000L
        private const val QUIET_MS = 60_000L
    }
}
