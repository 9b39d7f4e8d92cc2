package argo

import javino.Frame
import javino.Link
import javino.PortException
import javino.PortFaultException
import javino.PortTimeoutException
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** What the sensing of a port says; called by its thread. */
internal interface SensingListener {
    /** A message came; its last byte at [receivedNanos] by [System.nanoTime]. */
    fun received(port: OpenPort, message: String, receivedNanos: Long)

    /** The board did not answer in time. */
    fun unanswered(port: OpenPort, trouble: PortTimeoutException)

    /** The port cannot be used any more. */
    fun lost(port: OpenPort, trouble: PortException)
}

/**
 * Asks one board for its percepts, or listens to it, on a thread of its own, while the agent wants to perceive it.
 * The thread starts when sensing is first turned on and ends with [close] or the port.
 */
internal class Sensing(private val port: OpenPort, owner: String, private val listener: SensingListener) {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private var on = false
    private var closed = false
    private var intervalNanos = 0L
    private var lastStart: Long? = null
    private var quietUntil: Long? = null

    /**
     * How long the line is left free after a message, so that the command which it causes need not wait for the next request:
     * an eighth of what a request takes, which is about a hundredth of an exchange.
     */
    private val graceNanos = port.options.link.line().byteNanos() * Frame.of(PERCEPTS_REQUEST).toBytes().size / 8
    private val thread = lazy { daemonThread("argo-$owner-sensing-${port.link.port()}", ::run) }

    /** Turns sensing on, with [intervalMs] ms between requests (0: as fast as the line allows), or off. */
    fun set(on: Boolean, intervalMs: Int) = lock.withLock {
        this.on = on
        intervalNanos = TimeUnit.MILLISECONDS.toNanos(intervalMs.toLong())
        changed.signalAll()
        if (on && !closed) thread.value
    }

    /** Ends the thread; the link must be closed as well. May be called twice. */
    fun close() = lock.withLock {
        closed = true
        changed.signalAll()
        if (thread.isInitialized()) thread.value.interrupt()
    }

    private fun run() {
        try {
            while (awaitTurn()) if (!exchange()) return
        } catch (_: InterruptedException) {
            // close() ends this thread
        }
    }

    /** Waits until sensing is on and the next request is due; false when it is over. */
    private fun awaitTurn(): Boolean = lock.withLock {
        while (!closed) {
            val wait = nanosUntilDue(System.nanoTime())
            if (!on) changed.await()
            else if (wait > 0) changed.awaitNanos(wait)
            else {
                lastStart = System.nanoTime()
                return true
            }
        }
        false
    }

    private fun nanosUntilDue(now: Long): Long =
        maxOf(lastStart?.let { it + intervalNanos - now } ?: 0, quietUntil?.let { it - now } ?: 0)

    /** Takes one message from the board, on the caller's thread; false when the port is lost. */
    fun exchange(): Boolean = try {
        port.link.next(port.options)?.let {
            listener.received(port, it, System.nanoTime())
            quietUntil = System.nanoTime() + graceNanos
        }
        true
    } catch (silence: PortTimeoutException) {
        listener.unanswered(port, silence)
        true
    } catch (trouble: PortException) {
        listener.lost(port, trouble)
        false
    } catch (unforeseen: RuntimeException) { // a thread that dies silently would leave a stale world
        listener.lost(port, PortFaultException(port.link.port(), "sensing ended: $unforeseen", unforeseen))
        false
    }
}

/** The board's next message: the answer to a request, or what it says unasked; null when a board that speaks unasked is silent. */
internal fun Link.next(options: PortOptions): String? =
    if (!options.listens) request(PERCEPTS_REQUEST, options.timeoutMs)
    else try {
        listen(options.timeoutMs)
    } catch (_: PortTimeoutException) {
        null // such a board speaks when it has something to say
    }

/** The message that asks a board for its percepts. */
internal const val PERCEPTS_REQUEST = "getPercepts"
