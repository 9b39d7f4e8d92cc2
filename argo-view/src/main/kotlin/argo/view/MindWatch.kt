package argo.view

import java.util.concurrent.TimeUnit
import java.util.logging.Logger

/**
 * While a page is open, reads an agent's mind: on the agent's thread, between two cycles, at most ten times a second.
 *
 * @param read returns the mind; called only by the agent's thread
 * @param nanos a clock in ns that never goes back
 */
internal class MindWatch(private val read: () -> MindState, private val log: Logger, private val nanos: () -> Long) {
    @Volatile
    var isWatched = false
        set(value) {
            if (value && !field) missed = true
            field = value
        }

    /** The result of the last look; null if there was none yet. */
    @Volatile
    var newest: Seen? = null
        private set

    @Volatile
    private var missed = false

    @Volatile
    private var lookedNanos: Long? = null
    private var hasFailed = false

    /** Looks if a page is open and the last look is old enough. Called by the agent's thread, between two cycles or while paused. */
    fun look() {
        if (!isWatched) return
        if (isTooEarly()) {
            missed = true
        } else {
            missed = false
            lookedNanos = nanos()
            newest = seen() ?: newest
        }
    }

    /** Returns true if the look at the end of the last cycle came too early, and is due now. The agent may be asleep since then. */
    fun isBehind(): Boolean = isWatched && missed && !isTooEarly()

    private fun isTooEarly() = lookedNanos?.let { nanos() - it < INTERVAL_NANOS } == true

    private fun seen(): Seen? = try {
        Seen(nanos(), read())
    } catch (changed: RuntimeException) { // by a project's own belief base, or since another thread changes it
        if (!hasFailed) log.warning("the live view cannot read the agent's beliefs and intentions: $changed")
        hasFailed = true
        null
    }

    /** An agent's mind as it was seen at [nanos]. */
    class Seen(val nanos: Long, val mind: MindState)

    companion object {
        /** The shortest time between two looks, in ns. */
        val INTERVAL_NANOS: Long = TimeUnit.MILLISECONDS.toNanos(100)
    }
}
