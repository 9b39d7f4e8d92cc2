package argo.acting

import argo.platform.Platform
import argo.platform.nowMs
import java.util.TreeMap
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Numbers the commands that a board holds. The hand-over of the board's snapshots waits for the commands that were issued before the last
 * hand-over. Commands to another board count until no command has gone there for [ELSEWHERE_MS]. So commands do not pile up on a slow line,
 * and a line that stands still delays no other board. Safe for use by several threads.
 * @param nowMs a clock in ms that never goes back
 * @param countsElsewhere returns whether commands to another port count; false while the board on that port does not answer
 * @param port the port of the board itself; one object for one open port
 */
internal class CommandLedger(
    private val nowMs: () -> Long = Platform.system.nowMs,
    private val countsElsewhere: (Any) -> Boolean = { false },
    private val port: () -> Any?,
) {
    private val lock = ReentrantLock()
    private val pending = HashMap<Any, TreeMap<Long, Long>>() // by port, then by command number: the time of issue in ms
    private val movedMs = HashMap<Any, Long>() // by port: the time in ms at which a command last ended while others were pending
    private var issued = 0L

    fun issue(port: Any): Long = lock.withLock { (++issued).also { pending.getOrPut(port, ::TreeMap)[it] = nowMs() } }

    /** Notes that command [number] to [port] is over: it has gone out, failed or timed out. */
    fun done(port: Any, number: Long) = lock.withLock {
        pending.computeIfPresent(port) { _, commands -> commands.apply { remove(number) }.takeIf { it.isNotEmpty() } }
        if (port in pending) movedMs[port] = nowMs() else movedMs -= port
    }

    /** Returns true if commands to [port] count. */
    fun isPending(port: Any): Boolean = lock.withLock { port in pending }

    /** Returns the number of the command issued last; 0: none. */
    fun lastIssued(): Long = lock.withLock { issued }

    /** Returns true if none of the commands up to [number] counts any more. */
    fun allDoneUpTo(number: Long): Boolean {
        val own = port() ?: return true
        lock.withLock {
            if (pending.isEmpty()) return true
            if (pending[own]?.let { it.firstKey() <= number } == true) return false
        }
        return dueInMs(number) == null
    }

    /** Returns the ms for which commands up to [number] to other ports still count; null: no such command counts. */
    fun dueInMs(number: Long): Long? {
        val until = lastElsewhere(number).filterKeys(countsElsewhere).values.maxOrNull()?.plus(ELSEWHERE_MS) ?: return null
        return (until - nowMs()).takeIf { it > 0 }
    }

    /**
     * Returns a time for each other port with commands up to [number]: the time at which the last of them was issued or, if later, at which
     * a command there last ended.
     */
    private fun lastElsewhere(number: Long): Map<Any, Long> {
        val own = port()
        return lock.withLock {
            pending.entries.filter { (to, _) -> to != own }
                .mapNotNull { (to, commands) -> commands.floorEntry(number)?.let { to to maxOf(it.value, movedMs[to] ?: 0) } }.toMap()
        }
    }

    companion object {
        /** The ms for which commands to another port count while none of them goes out. */
        const val ELSEWHERE_MS = 100L
    }
}
