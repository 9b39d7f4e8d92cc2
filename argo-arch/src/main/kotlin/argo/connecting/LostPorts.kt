package argo.connecting

import argo.calls.failureOf
import argo.platform.Platform
import jason.asSyntax.Term
import javino.PortInterruptedException
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The ports of one agent whose devices have gone. Each is searched for on a thread of its own, so that a host which does not answer does
 * not delay a cable that is back. Safe for use by several threads.
 *
 * @param owner the agent's name, part of the threads' names
 * @param platform finds devices and schedules the looks
 * @param reopen opens a port whose device is present, and removes it from these
 * @param warn takes the reason why a port cannot be opened although its device has returned, once for each cause
 */
internal class LostPorts(
    private val owner: String,
    private val platform: Platform,
    private val reopen: (LostPort) -> Unit,
    private val warn: (String) -> Unit,
) {
    private val lock = ReentrantLock()
    private val lost = ArrayList<LostPort>()

    /** How many there are. */
    val size: Int get() = lock.withLock { lost.size }

    operator fun contains(port: LostPort): Boolean = lock.withLock { port in lost }

    /** Adds [ports]; the search begins with [lookFor]. */
    fun add(ports: List<LostPort>) {
        lock.withLock { lost += ports }
    }

    /** Removes the lost entries for [term] that belong to a port other than [port]. */
    fun removeOthers(term: Term, port: OpenPort) {
        lock.withLock { lost.removeAll { it.term == term && it.port !== port } }
    }

    /** Forgets the ports that were lost first until at most [max] remain. */
    fun keep(max: Int) = lock.withLock { while (lost.size > maxOf(0, max)) lost.removeAt(0) }

    /** Forgets all of them. */
    fun clear() = lock.withLock { lost.clear() }

    /** Looks for [port] now, and again until it is removed. */
    fun lookFor(port: LostPort) {
        platform.start("argo-$owner-looking-for-${port.name}") { look(port) }
    }

    private fun look(port: LostPort) {
        if (port !in this) return
        var isPresent = false
        val unknown = troubleOf { isPresent = platform.isPresent(port.name) }
        val isDue = port.looked(isPresent)
        val trouble = unknown ?: if (isDue) troubleOf { reopen(port) } else null
        if (trouble != null && trouble !is PortInterruptedException && port in this && port.failed(trouble)) {
            warn("port ${port.term} is still off: ${failureOf(trouble).cause}")
        }
        if (port in this) platform.later(port.nextLookMs()) { lookFor(port) }
    }
}

/** What [work] fails with, whatever a transport throws: a plan that waits for its port must go on. */
internal fun troubleOf(work: () -> Unit): Throwable? = try {
    work()
    null
} catch (trouble: Exception) {
    trouble
} catch (unloadable: LinkageError) { // the driver's native library
    unloadable
}
