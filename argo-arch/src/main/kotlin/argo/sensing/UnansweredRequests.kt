package argo.sensing

import java.util.concurrent.TimeUnit

/** How long a board that is asked has not answered. Safe for use by several threads. */
internal class UnansweredRequests {
    private class Span(val sinceNanos: Long, val requests: Int)

    @Volatile
    private var span: Span? = null

    /** Another request was not answered, which is known at [nowNanos]. */
    fun goesOn(nowNanos: Long) {
        span = span.let { Span(it?.sinceNanos ?: nowNanos, (it?.requests ?: 0) + 1) }
    }

    /** The board has answered, or is not asked for a while. */
    fun end() {
        span = null
    }

    /** Whether several requests in a row, and for [LONG_S] s, were not answered. */
    fun isLong(nowNanos: Long): Boolean =
        span?.let { it.requests >= LONG_REQUESTS && nowNanos - it.sinceNanos > TimeUnit.SECONDS.toNanos(LONG_S) } ?: false

    companion object {
        const val LONG_S = 10L
        private const val LONG_REQUESTS = 3
    }
}
