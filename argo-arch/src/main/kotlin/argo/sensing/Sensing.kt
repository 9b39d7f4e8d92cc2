package argo.sensing

import argo.platform.Platform
import argo.ports.OpenPort
import argo.ports.PortOptions
import argo.ports.whole
import javino.Frame
import javino.Link
import javino.PerceptsRequest
import javino.PortException
import javino.PortFaultException
import javino.PortGoneException
import javino.PortTimeoutException
import java.util.concurrent.TimeUnit
import kotlin.concurrent.withLock

/** What the sensing of a port says; called by its thread. */
internal interface SensingListener {
    /** What the board is to be asked now. */
    fun request(port: OpenPort): String

    /** A message came; its last byte at [receivedNanos] by the platform's clock. */
    fun received(port: OpenPort, message: String, receivedNanos: Long)

    /** The board did not answer in time. */
    fun unanswered(port: OpenPort, trouble: PortTimeoutException)

    /** The port cannot be used any more. */
    fun lost(port: OpenPort, trouble: PortException)
}

/**
 * Asks one board for its percepts, or listens to it, on a thread of its own, while the agent wants to perceive it. In between it
 * watches the line, so that a cable that is pulled is noticed whether or not the agent perceives or acts.
 * The thread starts when [set] is first called and ends with [close] or the port.
 */
internal class Sensing(
    private val port: OpenPort,
    owner: String,
    private val listener: SensingListener,
    platform: Platform,
) {
    private val clock = platform.clock
    private val lock = clock.newLock(false)
    private val changed = lock.newCondition()
    private var on = false
    private var closed = false

    @Volatile
    private var intervalNanos = 0L
    private var lastStart: Long? = null
    private val silence = UnansweredRequests()
    private var exchangeNanos = 0L

    /**
     * How long the line is left free before a request, so that the command which the last message caused need not wait for it:
     * an eighth of what a request takes, which is about a hundredth of an exchange.
     */
    private val graceNanos = port.options.link.line().byteNanos() * Frame.of(PerceptsRequest.ALL).toBytes().size / 8
    private val isPaced = port.link.settings().paced()
    private val thread = lazy { platform.start("argo-$owner-${if (isPaced) "sensing" else "watching"}-${port.link.port()}", ::run) }

    /** Turns sensing on, with [intervalMs] ms between requests (0: as fast as the line allows), or off. */
    fun set(on: Boolean, intervalMs: Int) = lock.withLock {
        if (!on) silence.end()
        this.on = on
        intervalNanos = TimeUnit.MILLISECONDS.toNanos(intervalMs.toLong())
        changed.signalAll()
        if (!closed) thread.value
    }

    /** Ends the thread; the link must be closed as well. May be called twice. */
    fun close() = lock.withLock {
        closed = true
        changed.signalAll()
        if (thread.isInitialized()) thread.value.interrupt()
    }

    private fun run() {
        try {
            while (!isClosed()) if (!(if (awaitTurn()) exchangeInTurn() else watch())) return
        } catch (_: InterruptedException) {
            // close() ends this thread
        }
    }

    private fun isClosed() = lock.withLock { closed }

    /** Waits until the next request is due; false if there is time to watch the line before it. */
    private fun awaitTurn(): Boolean = lock.withLock {
        while (on && !closed) {
            val wait = nanosUntilDue(clock.nanos())
            if (wait > WATCH_NANOS) return false
            if (wait <= 0) {
                lastStart = clock.nanos()
                return true
            }
            clock.await(changed, wait)
        }
        false
    }

    /** Where the agent's own thread takes what the board says, the line is only looked after. */
    private fun watch(): Boolean = if (isPaced) hear() else using {
        lock.withLock { clock.await(changed, WATCH_NANOS) }
        port.link.check()
    }

    /** What a board that is asked says meanwhile is dropped; one that speaks unasked may have been opened since this began. */
    private fun hear(): Boolean = using {
        val message = port.link.heard(WATCH_MS)
        if (message != null) port.hasSpoken = true
        if (message != null && port.options.listens && lock.withLock { on }) listener.received(port, message, clock.nanos())
    }

    /** A board that speaks unasked is listened to all the time: it knows itself how often it has something to say. */
    private fun nanosUntilDue(now: Long): Long =
        if (port.options.listens) 0 else lastStart?.let { it + intervalNanos - now } ?: 0

    /**
     * Lets out the commands that were issued before the request came due, and once more those that their going out has caused: one
     * that a request overtakes costs the agent a whole exchange. It gives way for two exchanges or intervals at most, so that
     * commands cannot starve sensing.
     */
    private fun exchangeInTurn(): Boolean {
        if (!port.options.listens) {
            val limit = maxOf(intervalNanos, exchangeNanos)
            port.commands.awaitEarlier(limit)
            lock.withLock { clock.await(changed, graceNanos) }
            port.commands.awaitEarlier(limit)
        }
        val start = clock.nanos()
        return exchange().also { exchangeNanos = clock.nanos() - start }
    }

    /** Takes one message from the board, on the caller's thread; false when the port is lost. */
    fun exchange(): Boolean = using {
        port.link.next(port.options) { listener.request(port) }?.let {
            port.hasSpoken = true
            silence.end()
            listener.received(port, it, clock.nanos())
        }
    }

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

    /** A far end in a network that used to answer may have gone without a word, and be back without knowing this connection. */
    private fun unanswered(timeout: PortTimeoutException): Boolean {
        silence.goesOn(clock.nanos())
        if (!(port.link.mayVanish() && port.hasSpoken && silence.isLong(clock.nanos()))) {
            listener.unanswered(port, timeout)
            return true
        }
        val name = port.link.port()
        listener.lost(port, PortGoneException(name, "port $name has not answered for ${UnansweredRequests.LONG_S} s; the connection is made anew"))
        return false
    }

    /** A thread that dies silently would leave a stale world. */
    private fun unforeseen(cause: Throwable): Boolean {
        listener.lost(port, PortFaultException(port.link.port(), "sensing ended: $cause", cause))
        return false
    }

    private companion object {
        /** How long a device may be gone before it is noticed, in ms, while nothing is asked of it. */
        const val WATCH_MS = 100
        const val WATCH_NANOS = WATCH_MS * 1_000_000L
    }
}

/** The board's next message: the answer to a request, or what it says unasked; null when a board that speaks unasked is silent. */
internal fun Link.next(options: PortOptions, request: () -> String): String? =
    if (options.listens) heard(options.timeoutMs) else request(request(), options.timeoutMs)

/** What the board says unasked within [timeoutMs] ms, or null. */
private fun Link.heard(timeoutMs: Int): String? = try {
    listen(timeoutMs)
} catch (_: PortTimeoutException) {
    null // it speaks when it has something to say
}
