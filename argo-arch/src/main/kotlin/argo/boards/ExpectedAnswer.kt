package argo.boards

import java.util.concurrent.TimeUnit

/**
 * When the answer of a board is expected, after the time that its last answers have taken. Changed by the sensing thread alone; any thread
 * may ask.
 */
internal class ExpectedAnswer {
    private var askedNanos = 0L
    private var usualNanos: Long? = null

    /** When the answer is expected to be there, by the platform's clock; null: none is under way, or nothing is known about it. */
    @Volatile
    private var expectedNanos: Long? = null

    /** The board is asked. */
    fun asked(nanos: Long) {
        askedNanos = nanos
        expectedNanos = usualNanos?.let { nanos + it }
    }

    /** The answer has come. */
    fun came(nanos: Long) {
        val took = nanos - askedNanos
        usualNanos = usualNanos?.let { it + (took - it) / WEIGHT } ?: took
        expectedNanos = null
    }

    /** The answer has not come in time, so none is waited for until one comes. */
    fun stayedOut() {
        usualNanos = null
        expectedNanos = null
    }

    /** Whether the answer is expected by now or within [GRACE_MS], and is not that much late. */
    fun isNear(nowNanos: Long): Boolean = expectedNanos?.let { it - nowNanos in -GRACE_NANOS..GRACE_NANOS } == true

    companion object {
        /** How long a snapshot waits for the answer of another board, in ms. */
        const val GRACE_MS = 2L
        val GRACE_NANOS = TimeUnit.MILLISECONDS.toNanos(GRACE_MS)
        private const val WEIGHT = 8
    }
}
