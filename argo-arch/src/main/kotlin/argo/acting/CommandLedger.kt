package argo.acting

import java.util.TreeSet
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Numbers an agent's commands, so that the hand-over of a snapshot can wait for the commands to the port in use that were issued before the
 * last hand-over. Safe for use by several threads.
 *
 * @param portInUse the port whose commands count; any object that is one and the same for one open port
 */
internal class CommandLedger(private val portInUse: () -> Any?) {
    private val lock = ReentrantLock()
    private val pending = HashMap<Any, TreeSet<Long>>()
    private var issued = 0L

    /** Enters a new command to [port] and returns its number. */
    fun issue(port: Any): Long = lock.withLock { (++issued).also { pending.getOrPut(port, ::TreeSet) += it } }

    /** Command [number] to [port] has gone out, failed or timed out. */
    fun done(port: Any, number: Long) = lock.withLock {
        pending.computeIfPresent(port) { _, commands -> commands.apply { remove(number) }.takeIf { it.isNotEmpty() } }
        Unit
    }

    /** The number of the command issued last, 0 if there is none. */
    fun lastIssued(): Long = lock.withLock { issued }

    /** Whether every command up to [number] to the port in use is done. */
    fun allDoneUpTo(number: Long): Boolean {
        val port = portInUse() ?: return true
        return lock.withLock { pending[port]?.let { it.first() > number } ?: true }
    }
}
