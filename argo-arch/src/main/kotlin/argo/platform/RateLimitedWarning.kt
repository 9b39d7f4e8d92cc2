package argo.platform

import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Logs a condition once when it begins, but not again while it lasts, or comes and goes. So a board that causes it all the time does not
 * fill the log. A condition ends after [QUIET_MS] without an occurrence. If there are more than [MAX_KINDS] conditions, the log says only
 * that there are others. Safe for use by several threads.
 *
 * @param nowMs a clock in ms that never goes back
 * @param warn takes the message
 */
internal class RateLimitedWarning(private val nowMs: () -> Long, private val warn: (String) -> Unit) {
    private val lock = ReentrantLock()
    private val lastMs = HashMap<String?, Long>() // by kind; null: all kinds for which there was no room

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
        /** A condition ends after this time without an occurrence, in ms. */
        const val QUIET_MS = 60_000L

        /** The most conditions at a time that are told apart. */
        const val MAX_KINDS = 100
    }
}
