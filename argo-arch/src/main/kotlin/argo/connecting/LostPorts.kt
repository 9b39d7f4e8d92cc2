package argo.connecting

import argo.calls.failureOf
import argo.platform.Platform
import jason.asSyntax.Term
import javino.PortInterruptedException
import javino.Transports
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * A lost port under one of the agent's names for it, with the time of the next look for the device. The first look only finds out whether
 * the device is there. A port may be lost repeatedly although its device is present: a serial server may accept each connection and then
 * hang up. A port that is lost repeatedly is opened at growing intervals. Used by one thread at a time.
 *
 * @property port the port that was lost
 * @property term the port as the agent calls it
 * @property name the name by which the transport opens the port
 * @param nowNanos the time by the platform's clock
 */
internal class LostPort(val port: OpenPort, val term: Term, val name: String, nowNanos: Long) {
    private val wasSound = port.hasSpoken || nowNanos - port.openedNanos >= SOUND_NANOS
    private var looks = 0
    private var delayMs = FIRST_DELAY_MS
    private val failures = HashMap<Class<*>, Int>()

    /** How many times in a row the port was lost soon after its opening; 0 if it worked for some time. */
    var losses = if (wasSound) 0 else port.losses + 1
        private set

    /** Notes whether a look has found the device. Returns true if the port must be opened now. */
    fun looked(present: Boolean): Boolean {
        if (!present) losses = 0
        if (looks++ == 0) {
            delayMs = minOf(FIRST_DELAY_MS shl losses.coerceAtMost(MAX_DOUBLINGS), MAX_DELAY_MS)
            return false
        }
        delayMs = minOf(2 * delayMs, MAX_LOOK_MS)
        return present
    }

    fun nextLookMs(): Long = delayMs

    /** Notes that the port could not be opened. Returns true for failure number [REPORTED_FAILURE] of its kind, which must be reported. */
    fun failed(trouble: Throwable): Boolean = failures.merge(trouble.javaClass, 1, Int::plus) == REPORTED_FAILURE

    private companion object {
        const val FIRST_DELAY_MS = 100L

        /** The longest time between two looks for a missing device. */
        const val MAX_LOOK_MS = 800L
        const val MAX_DELAY_MS = 10_000L
        const val MAX_DOUBLINGS = 10
        val SOUND_NANOS = TimeUnit.SECONDS.toNanos(2)

        /** Earlier failures are not reported, since the user may get the right to open a new device only after a short time. */
        const val REPORTED_FAILURE = 4
    }
}

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
