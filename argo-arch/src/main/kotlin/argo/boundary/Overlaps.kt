package argo.boundary

import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong

/**
 * Detects whether a cycle of a recorded agent overlaps with another cycle or with the reading of a program. In an overlap, nobody knows
 * which agent got which number from Jason's counters. Any thread may call the functions.
 */
object Overlaps {
    private val open = AtomicInteger()
    private val begun = AtomicLong()

    /** Begins a cycle, or the reading of a program. Returns its number for [end]. */
    fun begin(): Long = (open.getAndIncrement() == 0).let { isAlone -> begun.incrementAndGet().takeIf { isAlone } ?: -1 }

    /** Ends the cycle or the reading with this [number]. Returns true if nothing else ran meanwhile. */
    fun end(number: Long): Boolean {
        open.decrementAndGet()
        return number == begun.get()
    }
}
