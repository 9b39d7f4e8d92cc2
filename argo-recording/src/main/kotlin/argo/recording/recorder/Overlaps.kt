package argo.recording.recorder

import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong

/**
 * Detects overlapping cycles of recorded agents, in which nobody can tell which agent drew which number from Jason's counters. Any thread.
 */
internal object Overlaps {
    private val open = AtomicInteger()
    private val begun = AtomicLong()

    /** Begins a cycle. Returns its number for [end]. */
    fun begin(): Long = (open.getAndIncrement() == 0).let { isAlone -> begun.incrementAndGet().takeIf { isAlone } ?: -1 }

    /** Ends the cycle that began with [number]. Returns true if no other cycle ran meanwhile. */
    fun end(number: Long): Boolean {
        open.decrementAndGet()
        return number == begun.get()
    }
}
