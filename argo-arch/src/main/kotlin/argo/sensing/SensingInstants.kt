package argo.sensing

/**
 * The instants at which an agent that perceives several boards asks them. The instants are the multiples of the sensing interval, from the
 * clock's zero. Boards with equal intervals are asked together.
 */
internal object SensingInstants {
    /** Returns the first instant after [startNanos] for the interval [intervalNanos]. If the interval is 0, returns [startNanos]. */
    fun after(startNanos: Long, intervalNanos: Long): Long =
        if (intervalNanos == 0L) startNanos else (Math.floorDiv(startNanos, intervalNanos) + 1) * intervalNanos
}
