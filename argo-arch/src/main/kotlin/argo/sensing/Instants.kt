package argo.sensing

/**
 * The instants at which an agent that perceives several boards asks them: the multiples of the sensing interval, from the clock's zero. So
 * boards with the same interval are asked together.
 */
internal object Instants {
    /** Returns the first instant after [startNanos] for the interval [intervalNanos]; if that is 0, returns [startNanos]. */
    fun after(startNanos: Long, intervalNanos: Long): Long =
        if (intervalNanos == 0L) startNanos else (Math.floorDiv(startNanos, intervalNanos) + 1) * intervalNanos
}
