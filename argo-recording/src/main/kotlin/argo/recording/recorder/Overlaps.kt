package argo.recording.recorder

import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong

/**
 * Detects overlapping cycles of recorded agents. In overlapping cycles it is unknown which agent drew which number from Jason's counters.
 * Any thread may call.
 */
internal object Overlaps {
    private val open = AtomicInteger()
    private val begun = AtomicLong()

    /** Begins a cycle and returns its number for [end]. */
    fun begin(): Long = (open.getAndIncrement() == 0).let { isAlone -> begun.incrementAndGet().takeIf { isAlone } ?: -1 }

    /** Ends the cycle with this [number]. Returns true if no other cycle ran at the same time. */
    fun end(number: Long): Boolean {
        open.decrementAndGet()
        return number == begun.get()
    }
}
