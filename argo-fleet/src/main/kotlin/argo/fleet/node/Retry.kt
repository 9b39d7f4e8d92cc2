package argo.fleet.node

/**
 * Decides when to try again after a failure. The first wait is half a minute. The wait doubles with each further failure, up to an hour.
 *
 * @param nanos a clock in ns that never goes back
 */
internal class Retry(private val nanos: () -> Long) {
    private var waitNs = FIRST_NS
    private var next: Long? = null

    /** Adds a failure. Returns the time in ns until the next try. */
    fun failed(): Long {
        val wait = waitNs
        next = nanos() + wait
        waitNs = minOf(2 * wait, LONGEST_NS)
        return wait
    }

    /** Returns true once after each failure, when the time until the next try is over. */
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
