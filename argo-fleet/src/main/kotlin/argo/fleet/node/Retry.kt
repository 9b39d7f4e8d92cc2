package argo.fleet.node

/**
 * Says when to try again what has failed: after half a minute, and after twice the time at each further failure, an hour at most.
 *
 * @param nanos a clock in ns that never goes back
 */
internal class Retry(private val nanos: () -> Long) {
    private var waitNs = FIRST_NS
    private var next: Long? = null

    /** Notes a failure. Returns the time in ns until the next try. */
    fun failed(): Long {
        val wait = waitNs
        next = nanos() + wait
        waitNs = minOf(2 * wait, LONGEST_NS)
        return wait
    }

    /** Returns true once for each failure, when its time is over. */
    fun isDue(): Boolean {
        val isDue = next?.let { nanos() - it >= 0 } ?: false
        if (isDue) next = null
        return isDue
    }

    private companion object {
        const val FIRST_NS = 30_000_000_000L
        const val LONGEST_NS = 3_600_000_000_000L
    }
}
