package argo.platform

import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Logs a condition once when it begins, and not again while it lasts or comes and goes: a board that causes it all the time must not fill
 * the log. It ends after [QUIET_MS] without an occurrence. Safe for use by several threads.
 *
 * @param nowMs a clock in ms that never goes back
 * @param warn takes the message
 */
internal class RateLimitedWarning(private val nowMs: () -> Long, private val warn: (String) -> Unit) {
    private val lock = ReentrantLock()
    private var lastKind: String? = null
    private var lastMs = 0L

    /** Notes that the condition occurs now; another [kind] than before is a new condition. */
    fun report(kind: String, message: () -> String) {
        val isNew = lock.withLock {
            val now = nowMs()
            (kind != lastKind || now - lastMs > QUIET_MS).also {
                lastKind = kind
                lastMs = now
            }
        }
        if (isNew) warn(message())
    }

    companion object {
        /** The time without an occurrence after which a condition has ended, in ms. */
        const val QUIET_MS = 60_000L
    }
}
