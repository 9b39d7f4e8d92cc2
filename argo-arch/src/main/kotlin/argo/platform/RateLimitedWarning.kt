package argo.platform

import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Logs a condition once when it begins. A condition lasts until it has not occurred for [QUIET_MS]. A board that causes a condition
 * repeatedly does not fill the log. If more than [MAX_KINDS] conditions last, the log only says that there are others. Safe for use by
 * several threads.
 *
 * @param nowMs a clock in ms that never goes back
 * @param warn logs the message
 */
internal class RateLimitedWarning(private val nowMs: () -> Long, private val warn: (String) -> Unit) {
    private val lock = ReentrantLock()
    private val lastMs = HashMap<String?, Long>() // by kind; the key null is for all kinds beyond [MAX_KINDS]

    /** Notes that the condition [kind] occurs now. */
    fun report(kind: String, message: () -> String) {
        val more = lock.withLock {
            val now = nowMs()
            if (kind !in lastMs) lastMs.values.removeIf { now - it > QUIET_MS }
            val place = kind.takeIf { it in lastMs || lastMs.size < MAX_KINDS }
            val before = lastMs.put(place, now)
            when {
                before != null && now - before <= QUIET_MS -> return
                place == null -> "; others like this are not reported while there are so many"
                else -> ""
            }
        }
        warn(message() + more)
    }

    companion object {
        /** If a condition has not occurred for this time, in ms, it has ended. */
        const val QUIET_MS = 60_000L

        /** The largest number of conditions that are distinguished at a time. */
        const val MAX_KINDS = 100
    }
}
