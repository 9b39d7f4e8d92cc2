package argo.view

import java.util.concurrent.TimeUnit
import java.util.logging.Logger

/**
 * Looks into an agent's mind by the agent's own thread, between two reasoning cycles, while somebody watches, and ten times a second at
 * most.
 *
 * @param look what is seen; called by the agent's thread only
 * @param nanos a clock in ns that never goes back
 */
internal class MindWatch(private val look: () -> MindState, private val log: Logger, private val nanos: () -> Long) {
    /** Whether somebody watches. */
    @Volatile
    var isWatched = false
        set(value) {
            if (value && !field) missed = true
            field = value
        }

    /** What was seen last; null: nothing yet. */
    @Volatile
    var newest: Seen? = null
        private set

    @Volatile
    private var missed = false

    @Volatile
    private var lookedNanos: Long? = null
    private var hasFailed = false

    /** Looks if that is wanted. Called by the agent's thread. */
    fun cycleFinished() {
        if (!isWatched) return
        if (isTooEarly()) {
            missed = true
        } else {
            missed = false
            lookedNanos = nanos()
            newest = seen() ?: newest
        }
    }

    /** Whether a cycle has come to its end after which the watch should have looked by now: the agent may be sleeping. */
    fun isBehind(): Boolean = isWatched && missed && !isTooEarly()

    private fun isTooEarly() = lookedNanos?.let { nanos() - it < INTERVAL_NANOS } == true

    private fun seen(): Seen? = try {
        Seen(nanos(), look())
    } catch (changed: RuntimeException) { // a belief base of the project's own, or one that another thread changes: its agent must go on
        if (!hasFailed) log.warning("the live view cannot read the agent's beliefs and intentions: $changed")
        hasFailed = true
        null
    }

    /** What was seen of an agent's mind at [nanos]. */
    class Seen(val nanos: Long, val mind: MindState)

    companion object {
        /** The least time between two looks, in ns. */
        val INTERVAL_NANOS: Long = TimeUnit.MILLISECONDS.toNanos(100)
    }
}
