package argo.boards

import java.util.concurrent.TimeUnit

/**
 * When the answer of a board is expected, after the time that its last answers have taken. Changed by the sensing thread alone; any thread
 * may ask.
 */
internal class ExpectedAnswer {
    private var askedNanos: Long? = null
    private var usualNanos: Long? = null

    /** When the next answer is expected to be there, by the platform's clock; null: nothing is known about it. */
    @Volatile
    private var expectedNanos: Long? = null

    /** The board is asked. */
    fun asked(nanos: Long) {
        askedNanos = nanos
        expectAfter(nanos)
    }

    /** The answer has come, and is expected until it is [read]. */
    fun came(nanos: Long) {
        val asked = askedNanos ?: return // a board that speaks unasked
        val took = nanos - asked
        askedNanos = null
        usualNanos = usualNanos?.let { it + (took - it) / WEIGHT } ?: took
        expectedNanos = nanos
    }

    /** The answer can be perceived. The next is expected after [nextNanos], also before the board has been asked for it. */
    fun read(nextNanos: Long) = expectAfter(nextNanos)

    private fun expectAfter(nanos: Long) {
        expectedNanos = usualNanos?.let { nanos + it }
    }

    /** The answer has not come in time, so none is waited for until one comes. */
    fun stayedOut() {
        usualNanos = null
        expectedNanos = null
    }

    /** Whether the answer is expected within [SOON_NANOS], or is late by [LATE_NANOS] at most. */
    fun isNear(nowNanos: Long): Boolean = expectedNanos?.let { it - nowNanos in -LATE_NANOS..SOON_NANOS } == true

    companion object {
        /** How long a snapshot waits for an answer that is not due yet: each wait delays what has come. */
        val SOON_NANOS = TimeUnit.MILLISECONDS.toNanos(2)

        /** How long it waits for one that is late, which is seldom: eight boards on two processors answer some milliseconds apart. */
        val LATE_NANOS = TimeUnit.MILLISECONDS.toNanos(5)
        private const val WEIGHT = 8
    }
}
