package argo.sensing

/**
 * The instants at which an agent asks its boards, if it perceives several: the multiples of the sensing interval, counted from the
 * beginning of the clock. So boards with the same interval are asked together.
 */
internal object Instants {
    /** Returns the first instant after [startNanos], with an interval of [intervalNanos]; 0: at once. */
    fun after(startNanos: Long, intervalNanos: Long): Long =
        if (intervalNanos == 0L) startNanos else (Math.floorDiv(startNanos, intervalNanos) + 1) * intervalNanos
}
