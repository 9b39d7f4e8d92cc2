package argo.connecting

import jason.asSyntax.Term
import java.util.concurrent.TimeUnit

/**
 * A port whose device has gone, under one of its agent's names for the port, with the time of the next look for the device.
 *
 * The first look finds out if the device is there at all, and opens nothing. A port that is lost although its device is there, as with a
 * serial server that accepts every connection and then hangs up, is opened ever more seldom. Used by one thread at a time.
 *
 * @property port the port that was lost
 * @property term the port as the agent calls it
 * @property name the port in the form for the transport
 * @param nowNanos the time by the platform's clock
 */
internal class LostPort(val port: OpenPort, val term: Term, val name: String, nowNanos: Long) {
    private val wasSound = port.hasSpoken || nowNanos - port.openedNanos >= SOUND_NANOS
    private var looks = 0
    private var delayMs = FIRST_DELAY_MS
    private val failures = HashMap<Class<*>, Int>()

    /** The number of times in a row that the port was lost soon after it had been opened; 0: it worked for a while. */
    var losses = if (wasSound) 0 else port.losses + 1
        private set

    /**
     * Takes the result of a look.
     * @return whether the port is to be opened now
     */
    fun looked(present: Boolean): Boolean {
        if (!present) losses = 0
        if (looks++ == 0) {
            delayMs = minOf(FIRST_DELAY_MS shl losses.coerceAtMost(MAX_DOUBLINGS), MAX_DELAY_MS)
            return false
        }
        delayMs = minOf(2 * delayMs, MAX_LOOK_MS)
        return present
    }

    /** Returns the time until the next look, in ms. */
    fun nextLookMs(): Long = delayMs

    /**
     * Notes that the port could not be opened.
     * @return whether to report it: a failure of this kind is reported once, when it occurs for the [REPORTED_FAILURE]th time
     */
    fun failed(trouble: Throwable): Boolean = failures.merge(trouble.javaClass, 1, Int::plus) == REPORTED_FAILURE

    private companion object {
        const val FIRST_DELAY_MS = 100L

        /** The time between two looks for a device that is not there. */
        const val MAX_LOOK_MS = 800L
        const val MAX_DELAY_MS = 10_000L
        const val MAX_DOUBLINGS = 10
        val SOUND_NANOS = TimeUnit.SECONDS.toNanos(2)

        /** The number of failures before a report: for a moment after it is plugged in, this user may not open a device. */
        const val REPORTED_FAILURE = 4
    }
}
