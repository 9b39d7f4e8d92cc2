package argo.ports

import argo.calls.failureOf
import argo.platform.Platform
import jason.asSyntax.Term
import javino.PortInterruptedException
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The ports of one agent whose devices have gone. Each is looked for now and again, on a thread of its own: a host that does not answer must not
 * keep a cable that is back from being noticed. Safe for use by several threads.
 *
 * @param owner the agent's name, for the threads'
 * @param platform says what is there, and when to look
 * @param reopen opens a port whose device is there, and then takes it out of these
 * @param warn is told why a port cannot be opened though its device has returned, once for each cause
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

    /** Adds [ports], which are not looked for before [lookFor]. */
    fun add(ports: List<LostPort>) {
        lock.withLock { lost += ports }
    }

    /** What the agent calls [term] is no more lost than [port] is. */
    fun found(term: Term, port: OpenPort) {
        lock.withLock { lost.removeAll { it.term == term && it.port !== port } }
    }

    /** Forgets those that were lost first until there are [most] at most. */
    fun keep(most: Int) = lock.withLock { while (lost.size > maxOf(0, most)) lost.removeAt(0) }

    /** Forgets all. */
    fun clear() = lock.withLock { lost.clear() }

    /** Looks for [port] now, and again until it is none of these. */
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
