package argo.boards

import java.util.concurrent.TimeUnit

/** Predicts the time of a board's answer from the durations of its last answers. Only the sensing thread changes it; any thread may ask. */
internal class ExpectedAnswer {
    private var askedNanos: Long? = null
    private var usualNanos: Long? = null

    /** The expected time of the next answer, by the platform's clock; null: not known. */
    @Volatile
    private var expectedNanos: Long? = null

    fun asked(nanos: Long) {
        askedNanos = nanos
        expectAfter(nanos)
    }

    /** Notes that the answer has come. Until it is [read], the expected time is the time at which it came. */
    fun came(nanos: Long) {
        val asked = askedNanos ?: return // null: the board speaks unasked
        val took = nanos - asked
        askedNanos = null
        usualNanos = usualNanos?.let { it + (took - it) / WEIGHT } ?: took
        expectedNanos = nanos
    }

    /** Notes that the answer can be perceived. The next request goes out at [nextNanos]; its answer is expected from now on. */
    fun read(nextNanos: Long) = expectAfter(nextNanos)

    private fun expectAfter(nanos: Long) {
        expectedNanos = usualNanos?.let { nanos + it }
    }

    /** Notes that the answer has not come in time. No further answer is expected until the board answers again. */
    fun stayedOut() {
        usualNanos = null
        expectedNanos = null
    }

    /** Returns true if the answer is expected within [SOON_NANOS], or is late by [LATE_NANOS] at most. */
    fun isNear(nowNanos: Long): Boolean = expectedNanos?.let { it - nowNanos in -LATE_NANOS..SOON_NANOS } == true

    companion object {
        /** The longest wait of a snapshot for an answer that is not late: each wait delays percepts that have already come. */
        val SOON_NANOS = TimeUnit.MILLISECONDS.toNanos(2)

        /** The longest wait for a late answer. Late answers are rare: eight boards on two processors answer some milliseconds apart. */
        val LATE_NANOS = TimeUnit.MILLISECONDS.toNanos(5)
        private const val WEIGHT = 8
    }
}
