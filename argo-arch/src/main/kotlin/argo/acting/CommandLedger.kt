package argo.acting

import argo.platform.Platform
import argo.platform.nowMs
import java.util.TreeMap
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The commands for which the snapshots of a board wait, by number. A snapshot waits for commands that were issued before the last
 * hand-over, so commands do not pile up on a slow line. Commands to another port stop counting if none of them has ended for
 * [ELSEWHERE_MS], so a blocked line does not delay other boards. Safe for use by several threads.
 *
 * @param nowMs a clock in ms that never goes back
 * @param countsElsewhere returns true if commands to another port count, since the board on this port answers
 * @param port returns the port of the board itself; each open port is one object
 */
internal class CommandLedger(
    private val nowMs: () -> Long = Platform.system.nowMs,
    private val countsElsewhere: (Any) -> Boolean = { false },
    private val port: () -> Any?,
) {
    private val lock = ReentrantLock()
    private val pending = HashMap<Any, TreeMap<Long, Long>>() // by port and command number: the time of issue in ms
    private val movedMs = HashMap<Any, Long>() // by port, if it has pending commands: the time in ms at which its last command ended
    private var issued = 0L

    fun issue(port: Any): Long = lock.withLock { (++issued).also { pending.getOrPut(port, ::TreeMap)[it] = nowMs() } }

    /** Notes that command [number] to [port] was sent, has failed or has timed out. */
    fun done(port: Any, number: Long) = lock.withLock {
        pending.computeIfPresent(port) { _, commands -> commands.apply { remove(number) }.takeIf { it.isNotEmpty() } }
        if (port in pending) movedMs[port] = nowMs() else movedMs -= port
    }

    fun isPending(port: Any): Boolean = lock.withLock { port in pending }

    /** Returns the number of the last issued command; 0 if none was issued. */
    fun lastIssued(): Long = lock.withLock { issued }

    /** Returns true if no snapshot needs to wait for the commands up to [number]. */
    fun allDoneUpTo(number: Long): Boolean {
        val own = port() ?: return true
        lock.withLock {
            if (pending.isEmpty()) return true
            if (pending[own]?.let { it.firstKey() <= number } == true) return false
        }
        return dueInMs(number) == null
    }

    /** Returns for how many ms the commands up to [number] to other ports still count; null if none counts. */
    fun dueInMs(number: Long): Long? {
        val until = lastElsewhere(number).filterKeys(countsElsewhere).values.maxOrNull()?.plus(ELSEWHERE_MS) ?: return null
        return (until - nowMs()).takeIf { it > 0 }
    }

    /**
     * For each other port that has commands up to [number], returns the later of two times: the issue of the last of these commands, and
     * the last end of a command to the port.
     */
    private fun lastElsewhere(number: Long): Map<Any, Long> {
        val own = port()
        return lock.withLock {
            pending.entries.filter { (to, _) -> to != own }
                .mapNotNull { (to, commands) -> commands.floorEntry(number)?.let { to to maxOf(it.value, movedMs[to] ?: 0) } }.toMap()
        }
    }

    companion object {
        /** For how many ms commands to another port count while none of them ends. */
        const val ELSEWHERE_MS = 100L
    }
}
