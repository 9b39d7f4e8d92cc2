package argo.connecting

import argo.calls.failureOf
import argo.platform.Platform
import jason.asSyntax.Term
import javino.PortInterruptedException
import javino.Transports
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The lost ports of one agent. Their devices have gone. Each port has its own searching thread, so a host that does not answer delays no
 * other search. Safe for use by several threads.
 *
 * @param reopen opens a port after its device has returned, and removes the port from the lost ports
 * @param warn receives warnings: a returned device cannot be opened (once for each kind of reason), or a port is given up
 */
internal class LostPorts(
    private val owner: String,
    private val platform: Platform,
    private val reopen: (LostPort) -> Unit,
    private val warn: (String) -> Unit,
) {
    private val lock = ReentrantLock()
    private val lost = ArrayList<LostPort>()
    private val closing = LinkedHashMap<OpenPort, Set<String>>() // lost ports that are not closed yet, with their names

    val size: Int get() = lock.withLock { lost.size }

    operator fun contains(port: LostPort): Boolean = lock.withLock { port in lost }

    fun add(ports: List<LostPort>) = lock.withLock {
        lost += ports
        ports.forEach { closing.merge(it.port, setOf(it.name), Set<String>::plus) }
    }

    /** Removes the lost ports that the agent calls [term], except [port]. */
    fun removeOthers(term: Term, port: OpenPort) {
        lock.withLock { lost.removeAll { it.term == term && it.port !== port } }
    }

    /** Gives up the ports that were lost first until at most [max] remain. */
    fun keep(max: Int) {
        val givenUp = lock.withLock { lost.take(maxOf(0, lost.size - maxOf(0, max))).also { lost -= it.toSet() } }
        givenUp.forEach { warn("port ${it.term} is looked for no more: the agent has as many other ports as it may have") }
    }

    /** Forgets all lost ports. Ports that are not closed yet are still closed later. */
    fun clear() = lock.withLock { lost.clear() }

    /** Closes the lost ports of the device with the [canonical name][Transports.canonicalName] [key]. Returns when the device is free. */
    fun close(key: String) = lock.withLock { closing.toMap() }
        .filterValues { names -> names.any { runCatching { Transports.canonicalName(it) }.getOrDefault(it) == key } }
        .keys.forEach(::close)

    fun closeAll() = lock.withLock { closing.keys.toList() }.forEach(::close)

    private fun close(port: OpenPort) {
        port.close()
        lock.withLock { closing -= port }
    }

    /** Closes [port], and looks for its device until [port] is removed. Does not wait. */
    fun lookFor(port: LostPort) {
        val trouble = troubleOf { platform.start("argo-$owner-looking-for-${port.name}") { look(port) } }
        if (trouble != null) lookLater(port, trouble) // the machine has no thread for the look
    }

    private fun lookLater(port: LostPort, trouble: Throwable?) {
        if (trouble != null && trouble !is PortInterruptedException && port in this && port.failed(trouble)) {
            warn("port ${port.term} is still off: ${failureOf(trouble).cause}")
        }
        if (port in this) platform.later(port.nextLookMs()) { lookFor(port) }
    }

    private fun look(port: LostPort) {
        var isPresent = false
        val unknown = troubleOf {
            close(port.port) // closed here, since the thread that notices the loss must not wait
            isPresent = port in this && platform.isPresent(port.name)
        }
        if (port !in this) return
        val isDue = port.looked(isPresent)
        lookLater(port, unknown ?: if (isDue) troubleOf { reopen(port) } else null)
    }
}

/** Does [work] and returns the exception that it throws, or null. Protects the threads that open ports or search for devices. */
internal fun troubleOf(work: () -> Unit): Throwable? = try {
    work()
    null
} catch (trouble: Throwable) {
    trouble
}
