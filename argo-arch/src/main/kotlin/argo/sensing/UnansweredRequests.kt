package argo.sensing

import java.util.concurrent.TimeUnit

/** Counts the requests in a row that a board has not answered, and keeps the time of the first. Not safe for use by several threads. */
internal class UnansweredRequests {
    private var sinceNanos = 0L
    private var count = 0

    /** Counts one more unanswered request. Its time limit was over at [nowNanos]. */
    fun add(nowNanos: Long) {
        if (count++ == 0) sinceNanos = nowNanos
    }

    /** Forgets the count. Called when the board has answered, or is not asked for a while. */
    fun clear() {
        count = 0
    }

    /** Returns true if at least [LONG_COUNT] requests in a row were not answered, for longer than [LONG_S] s. */
    fun isLong(nowNanos: Long): Boolean = count >= LONG_COUNT && nowNanos - sinceNanos > TimeUnit.SECONDS.toNanos(LONG_S)

    companion object {
        const val LONG_S = 10L
        private const val LONG_COUNT = 3
    }
}
