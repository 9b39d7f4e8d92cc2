package argo.connecting

import jason.asSyntax.Term
import java.util.concurrent.TimeUnit

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
