package argo.boards

import java.util.concurrent.TimeUnit

/**
 * Predicts when a board will answer, from the durations of its last answers. The sensing thread changes this object. Any thread may read
 * it.
 */
internal class ExpectedAnswer {
    private var askedNanos: Long? = null
    private var usualNanos: Long? = null

    /** The expected time of the next answer, by the platform's clock; null if it is not known. */
    @Volatile
    private var expectedNanos: Long? = null

    fun asked(nanos: Long) {
        askedNanos = nanos
        expectAfter(nanos)
    }

    /** Notes that the answer has come. [nanos] is the expected time until [read] is called. */
    fun came(nanos: Long) {
        val asked = askedNanos ?: return // null if the board sends without requests
        val took = nanos - asked
        askedNanos = null
        usualNanos = usualNanos?.let { it + (took - it) / WEIGHT } ?: took
        expectedNanos = nanos
    }

    /** Notes that the answer can be perceived. From now on, the answer to the request at [nextNanos] is expected. */
    fun read(nextNanos: Long) = expectAfter(nextNanos)

    private fun expectAfter(nanos: Long) {
        expectedNanos = usualNanos?.let { nanos + it }
    }

    /** Notes that the answer has not come in time. No answer is expected until the board answers again. */
    fun stayedOut() {
        usualNanos = null
        expectedNanos = null
    }

    /** Returns true if the answer is expected within [SOON_NANOS], or is late by at most [LATE_NANOS]. */
    fun isNear(nowNanos: Long): Boolean = expectedNanos?.let { it - nowNanos in -LATE_NANOS..SOON_NANOS } == true

    companion object {
        /** The longest time that a snapshot waits before an answer's expected time. This wait delays percepts. */
        val SOON_NANOS = TimeUnit.MILLISECONDS.toNanos(2)

        /** The longest time that a snapshot waits after an answer's expected time. Eight boards on two processors answer some ms apart. */
        val LATE_NANOS = TimeUnit.MILLISECONDS.toNanos(5)
        private const val WEIGHT = 8
    }
}
