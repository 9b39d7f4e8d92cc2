package argo.sensing

import argo.platform.Platform
import argo.ports.OpenPort
import javino.Link
import javino.PortException
import javino.PortFaultException
import javino.PortGoneException
import javino.PortTimeoutException
import javino.Reply
import java.util.concurrent.TimeUnit
import kotlin.concurrent.withLock

/** What the sensing of a port asks and reports. Called by the port's sensing thread. */
internal interface SensingListener {
    /** Whether [port] is to be sensed now. Any thread; a change is signalled by [Sensing.wake]. */
    fun isSensed(port: OpenPort): Boolean

    /** The sensing interval in ms, 0: as fast as the line allows. Any thread; a change is signalled by [Sensing.wake]. */
    val intervalMs: Int

    /** The request that the board is to answer. */
    fun request(port: OpenPort): String

    /** A message came; its last byte at [receivedNanos] by the platform's clock. */
    fun received(port: OpenPort, message: String, receivedNanos: Long)

    /** The board did not answer in time. */
    fun unanswered(port: OpenPort, trouble: PortTimeoutException)

    /** The board has answered after [unanswered]. */
    fun answeredAgain(port: OpenPort)

    /** The port cannot be used any more. */
    fun lost(port: OpenPort, trouble: PortException)
}

/**
 * Asks one board for its percepts, or listens to it, on a thread of its own, while the agent wants to perceive it. In between it
 * watches the line, so that a pulled cable is noticed whether or not the agent perceives or acts.
 *
 * It keeps no copy of what the agent wants: it asks [listener] each time, so that no change can be lost between two threads.
 */
internal class Sensing(
    private val port: OpenPort,
    owner: String,
    private val listener: SensingListener,
    platform: Platform,
) : AutoCloseable {
    private val clock = platform.clock
    private val lock = clock.newLock(false)
    private val changed = lock.newCondition()
    private var closed = false
    private var lastStart: Long? = null
    private val unanswered = UnansweredRequests()
    private var isTimedOut = false
    private val isPaced = port.link.settings().paced()
    private val thread = lazy { platform.start("argo-$owner-${if (isPaced) "sensing" else "watching"}-${port.link.port()}", ::run) }

    /** Starts the thread, which ends with [close] or the port. */
    fun start() = lock.withLock { if (!closed) thread.value }

    /** Signals that the answers of the listener may have changed. */
    fun wake() = lock.withLock {
        if (!listener.isSensed(port)) unanswered.clear()
        changed.signalAll()
    }

    /** Ends the thread; the link must be closed as well. May be called twice. */
    override fun close() = lock.withLock {
        closed = true
        changed.signalAll()
        if (thread.isInitialized()) thread.value.interrupt()
    }

    private fun run() {
        try {
            while (!isClosed()) if (!(if (awaitTurn()) exchange() else watch())) return
        } catch (_: InterruptedException) {
            // close() ends this thread
        }
    }

    private fun isClosed() = lock.withLock { closed }

    /** Waits until the next request is due; false if it is time to look at the line before. */
    private fun awaitTurn(): Boolean = lock.withLock {
        var wait = nanosUntilDue()
        if (wait > WATCH_NANOS) {
            clock.await(changed, WATCH_NANOS)
            wait = nanosUntilDue()
        }
        while (wait in 1..WATCH_NANOS && !closed) {
            clock.await(changed, wait)
            wait = nanosUntilDue()
        }
        (wait <= 0).also { if (it) lastStart = clock.nanos() }
    }

    /** The time until the next request, for ever if none is wanted. A board that speaks unasked is listened to all the time. */
    private fun nanosUntilDue(): Long = when {
        !isPaced || !listener.isSensed(port) -> Long.MAX_VALUE // not paced: the agent's own thread takes the messages
        port.options.listens -> 0
        else -> lastStart?.let { it + TimeUnit.MILLISECONDS.toNanos(listener.intervalMs.toLong()) - clock.nanos() } ?: 0
    }

    /** Looks at the line. Messages that nobody wants now are dropped, but where the agent's own thread takes them. */
    private fun watch(): Boolean = using {
        if (isPaced) port.link.heard(LOOK_MS)?.let { port.hasSpoken = true } else port.link.check()
    }

    /** Takes one message from the board, on the caller's thread; false when the port is lost. */
    fun exchange(): Boolean = using {
        val reply = if (port.options.listens) port.link.heard(port.options.timeoutMs) else ask()
        if (reply != null) {
            port.hasSpoken = true
            lock.withLock { unanswered.clear() }
            if (isTimedOut) listener.answeredAgain(port)
            isTimedOut = false
            listener.received(port, reply.text(), reply.receivedNanos())
        }
    }

    private fun ask(): Reply =
        if (isPaced) port.link.request({ listener.request(port) }, port.options.timeoutMs, listener.intervalMs)
        else port.link.request(listener.request(port), port.options.timeoutMs)

    /** Does [work] with the line; false when the port is lost. */
    private fun using(work: () -> Unit): Boolean = try {
        work()
        true
    } catch (timeout: PortTimeoutException) {
        unanswered(timeout)
    } catch (trouble: PortException) {
        listener.lost(port, trouble)
        false
    } catch (unforeseen: RuntimeException) {
        unforeseen(unforeseen)
    } catch (unforeseen: LinkageError) { // the driver's native library
        unforeseen(unforeseen)
    }

    /** The far end of a network connection may have gone without a word, and may be back without knowing this connection. */
    private fun unanswered(timeout: PortTimeoutException): Boolean {
        isTimedOut = true
        val isLong = lock.withLock {
            val now = clock.nanos()
            unanswered.add(now)
            unanswered.isLong(now)
        }
        if (!(isLong && port.link.mayVanish() && port.hasSpoken)) {
            listener.unanswered(port, timeout)
            return true
        }
        val name = port.link.port()
        val reason = "port $name has not answered for ${UnansweredRequests.LONG_S} s; the connection is made anew"
        listener.lost(port, PortGoneException(name, reason))
        return false
    }

    /** A thread that dies silently would leave a stale world. */
    private fun unforeseen(cause: Throwable): Boolean {
        listener.lost(port, PortFaultException(port.link.port(), "sensing ended: $cause", cause))
        return false
    }

    private companion object {
        /** How long a device may be gone before it is noticed, while nothing is asked of it. */
        val WATCH_NANOS = TimeUnit.MILLISECONDS.toNanos(100)
        const val LOOK_MS = 1
    }
}

/** What the board says unasked within [timeoutMs] ms, or null. */
private fun Link.heard(timeoutMs: Int): Reply? = try {
    listen(timeoutMs)
} catch (_: PortTimeoutException) {
    null // it speaks when it has something to say
}
