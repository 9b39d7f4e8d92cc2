package argo.recording.recorder

import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong

/** Which cycles of recorded agents overlap: what each of them has drawn from Jason's counters cannot be told apart then. Any thread. */
internal object Overlaps {
    private val open = AtomicInteger()
    private val begun = AtomicLong()

    /** A cycle begins. Returns what [end] wants. */
    fun begin(): Long = (open.getAndIncrement() == 0).let { isAlone -> begun.incrementAndGet().takeIf { isAlone } ?: -1 }

    /** The cycle ends that began with [number]; whether no other one ran meanwhile. */
    fun end(number: Long): Boolean {
        open.decrementAndGet()
        return number == begun.get()
    }
}
