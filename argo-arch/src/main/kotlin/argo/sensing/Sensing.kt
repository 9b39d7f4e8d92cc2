package argo.sensing

import argo.connecting.OpenPort
import argo.links.BoardMessage
import argo.platform.Platform
import javino.PortException
import javino.PortFaultException
import javino.PortGoneException
import javino.PortTimeoutException
import java.util.concurrent.TimeUnit
import kotlin.concurrent.withLock

/** Tells the sensing of a port what the agent wants, and receives the port's messages. Called by the port's sensing thread. */
internal interface SensingListener {
    /** Returns true if the agent wants [port] to be sensed now. Called by any thread. [Sensing.wake] signals a change. */
    fun isSensed(port: OpenPort): Boolean

    /** The sensing interval in ms; 0 means as fast as the line allows. Read by any thread. [Sensing.wake] signals a change. */
    val intervalMs: Int

    /** Returns the time of the next request to a board that was asked at [startNanos], by the platform's clock. */
    fun nextStart(startNanos: Long): Long = startNanos + TimeUnit.MILLISECONDS.toNanos(intervalMs.toLong())

    /** Returns the text of the request for the board. Called when the request goes out. */
    fun request(port: OpenPort): String

    /** Returns true if the board on [port] may report critical percepts between two messages. Called by any thread. */
    fun mayReport(port: OpenPort): Boolean

    /** Receives [message]. The request for it went out at [askedNanos], by the platform's clock. */
    fun received(port: OpenPort, message: BoardMessage, askedNanos: Long)

    /** Reports that the board did not answer in time. */
    fun unanswered(port: OpenPort, trouble: PortTimeoutException)

    /** Reports that the board has answered after [unanswered]. */
    fun answeredAgain(port: OpenPort)

    /** Reports that the port cannot be used any more. */
    fun lost(port: OpenPort, trouble: PortException)
}

/**
 * Asks one board for its percepts, or listens to it, while the agent wants to perceive the board. Uses a separate thread. Between two
 * messages this thread watches the line, so a pulled cable is noticed even if the agent neither perceives nor acts. Sensing always asks
 * [listener] what the agent wants and keeps no copy, so no change is missed.
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
    private var askedNanos = clock.nanos()
    private val unanswered = UnansweredRequests()
    private var isTimedOut = false
    private val isPaced = port.link.isPaced
    private val thread = lazy { platform.start("argo-$owner-${if (isPaced) "sensing" else "watching"}-${port.link.port}", ::run) }

    /** Starts the thread. [close] or the loss of the port ends sensing. */
    fun start() = lock.withLock { if (!closed) thread.value }

    /** Signals that the answers of the listener may have changed. */
    fun wake() = lock.withLock {
        if (!listener.isSensed(port)) unanswered.clear()
        changed.signalAll()
    }

    /** Ends the thread, but does not close the link. Further calls have no effect. */
    override fun close() = lock.withLock {
        closed = true
        changed.signalAll()
        if (thread.isInitialized()) thread.value.interrupt()
    }

    private fun run() {
        try {
            while (!isClosed()) if (!(if (awaitTurn()) exchange() else watch())) return
        } catch (_: InterruptedException) {
            // close() has interrupted this thread to end it
        }
    }

    private fun isClosed() = lock.withLock { closed }

    /** Waits until the next request is due and returns true. Returns false if the thread must look at the line first. */
    private fun awaitTurn(): Boolean = lock.withLock {
        var wait = nanosUntilDue()
        if (wait >= SLICE_NANOS && mayReport()) return false // the thread reads the line while it waits
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

    /** Returns the time until the next request. It is endless if no request is wanted, and 0 if ARGO only listens to the board. */
    private fun nanosUntilDue(): Long = when {
        !isPaced || !listener.isSensed(port) -> Long.MAX_VALUE // if a line is not paced, the agent's own thread takes the messages
        listens() -> 0
        else -> lastStart?.let { listener.nextStart(it) - clock.nanos() } ?: 0
    }

    private fun listens() = port.options.listens || port.link.speaksUnasked

    private fun mayReport() = isPaced && !listens() && listener.mayReport(port)

    /** Looks at the line, and drops unwanted messages. Under `argo_sensing=in_cycle`, only checks the line. */
    private fun watch(): Boolean = using {
        when {
            !isPaced -> port.link.check()
            mayReport() -> port.link.watch(sliceMs())
            port.link.speaksUnasked -> port.link.check()
            else -> port.link.listen(LOOK_MS)?.let { port.hasSpoken = true }
        }
    }

    /**
     * Returns the ms for one look at the line. The look ends by the next request, and soon enough to notice a change of the agent's wishes.
     */
    private fun sliceMs(): Int = lock.withLock { TimeUnit.NANOSECONDS.toMillis(nanosUntilDue()) }.coerceIn(1, MAX_SLICE_MS).toInt()

    /** Receives one message from the board, on the caller's thread. Returns false if the port is lost. */
    fun exchange(): Boolean = using {
        val timeoutMs = port.options.timeoutMs
        val message = if (listens()) port.link.listen(timeoutMs) else port.link.request(::requestNow, timeoutMs, listener.intervalMs)
        lock.withLock { unanswered.clear() }
        if (isTimedOut) listener.answeredAgain(port)
        isTimedOut = false
        if (message != null) {
            port.hasSpoken = true
            listener.received(port, message, askedNanos)
            if (listens()) askedNanos = message.receivedNanos // the board makes the next message later
        }
    }

    private fun requestNow(): String {
        askedNanos = clock.nanos()
        return listener.request(port)
    }

    /** Does [work], which uses the line. Returns false if the port is lost. */
    private fun using(work: () -> Unit): Boolean = try {
        work()
        true
    } catch (timeout: PortTimeoutException) {
        unanswered(timeout)
    } catch (trouble: PortException) {
        listener.lost(port, trouble)
        false
    } catch (ending: InterruptedException) {
        throw ending
    } catch (unforeseen: Throwable) {
        unforeseen(unforeseen)
    }

    /** Handles a missing answer. The far end of a network may vanish unnoticed, and return without the connection. */
    private fun unanswered(timeout: PortTimeoutException): Boolean {
        isTimedOut = true
        val isLong = lock.withLock {
            val now = clock.nanos()
            unanswered.add(now)
            unanswered.isLong(now)
        }
        if (!(isLong && port.link.mayVanish && port.hasSpoken)) {
            listener.unanswered(port, timeout)
            return true
        }
        val name = port.link.port
        val reason = "port $name has not answered for ${UnansweredRequests.LONG_S} s; the connection is made anew"
        listener.lost(port, PortGoneException(name, reason))
        return false
    }

    /** Reports an unforeseen exception as a lost port. If the thread died silently, the agent would perceive a stale world. */
    private fun unforeseen(cause: Throwable): Boolean {
        listener.lost(port, PortFaultException(port.link.port, "sensing ended: $cause", cause))
        return false
    }

    private companion object {
        /** While no requests are sent, a lost device is noticed within this time, in ns. */
        val WATCH_NANOS = TimeUnit.MILLISECONDS.toNanos(100)
        const val LOOK_MS = 1
        const val MAX_SLICE_MS = 10L
        val SLICE_NANOS = TimeUnit.MILLISECONDS.toNanos(1)
    }
}
