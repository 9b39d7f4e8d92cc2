package argo.connecting

import jason.asSyntax.Term
import java.util.concurrent.TimeUnit

/**
 * A port whose device has gone, by one of the names that its agent has for it, and when to look for it again.
 *
 * The first look finds out whether the device is there at all, and opens nothing: a port that is lost although its device is there, as with
 * a serial server that accepts whoever comes and then hangs up, is opened ever more seldom. One thread at a time.
 *
 * @property port what was lost with it
 * @property term the port as the agent calls it
 * @property name the same, as the transport takes it
 * @param nowNanos by the platform's clock
 */
internal class LostPort(val port: OpenPort, val term: Term, val name: String, nowNanos: Long) {
    private val wasSound = port.hasSpoken || nowNanos - port.openedNanos >= SOUND_NANOS
    private var looks = 0
    private var delayMs = FIRST_DELAY_MS
    private val failures = HashMap<Class<*>, Int>()

    /** How often in a row the port was lost soon after it had been opened: 0 for one that worked. */
    var losses = if (wasSound) 0 else port.losses + 1
        private set

    /**
     * Takes in what a look has found.
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

    /** The time until the next look, in ms. */
    fun nextLookMs(): Long = delayMs

    /**
     * Takes in that the port could not be opened.
     * @return whether to report it: the cause has stood for several looks, and has not been reported
     */
    fun failed(trouble: Throwable): Boolean = failures.merge(trouble.javaClass, 1, Int::plus) == REPORTED_FAILURE

    private companion object {
        const val FIRST_DELAY_MS = 100L

        /** The time between two looks for a device that is not there. */
        const val MAX_LOOK_MS = 800L
        const val MAX_DELAY_MS = 10_000L
        const val MAX_DOUBLINGS = 10
        val SOUND_NANOS = TimeUnit.SECONDS.toNanos(2)

        /** A device that was plugged in a moment ago is not this user's yet. */
        const val REPORTED_FAILURE = 4
    }
}
