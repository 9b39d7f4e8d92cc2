package argo.sensing


/**
 * How long ago a board's last message came. Safe for use by several threads.
 *
 * @param nowMs a clock in ms that never goes back
 */
internal class Staleness(private val nowMs: () -> Long) {
    @Volatile
    private var freshMs = nowMs()

    /** A message has come, or only now is one awaited. */
    fun renew() {
        freshMs = nowMs()
    }

    /** In how many ms [limitMs] ms without a message are over; 0: they are. */
    fun dueInMs(limitMs: Long): Long = maxOf(0, freshMs + limitMs - nowMs())
}
