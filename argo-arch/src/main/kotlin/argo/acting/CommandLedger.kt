package argo.acting

import java.util.TreeSet
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Counts an agent's commands, so that the hand-over of a snapshot can wait for those that were issued before the last one.
 *
 * Safe for use by several threads.
 */
internal class CommandLedger {
    private val lock = ReentrantLock()
    private val pending = TreeSet<Long>()
    private var issued = 0L

    /** Enters a new command and returns its number. */
    fun issue(): Long = lock.withLock { (++issued).also { pending += it } }

    /** Command [number] has gone out, failed or timed out. */
    fun done(number: Long) {
        lock.withLock { pending -= number }
    }

    /** What has been issued is awaited no longer. */
    fun forget() = lock.withLock { pending.clear() }

    /** The number of the command issued last, 0 if there is none. */
    fun lastIssued(): Long = lock.withLock { issued }

    /** Whether every command up to [number] is done. */
    fun allDoneUpTo(number: Long): Boolean = lock.withLock { pending.isEmpty() || pending.first() > number }
}
