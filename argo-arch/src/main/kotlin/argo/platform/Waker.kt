package argo.platform

import jason.architecture.AgArch
import java.util.concurrent.atomic.AtomicLong

/**
 * Wakes an agent that sleeps or is about to.
 *
 * Jason's wake-up is lost when it comes between an agent's decision to sleep and its sleep, which then lasts up to a second.
 * So it is repeated, ever more slowly, until the agent has seen what it was woken for.
 */
internal class Waker(private val arch: AgArch, private val platform: Platform = Platform.system) {
    private val nextWake = AtomicLong(Long.MAX_VALUE)

    @Volatile
    private var perceivedMs = Long.MIN_VALUE

    /** Wakes the agent now and again until [seen]; [seen] is asked by other threads. */
    fun wake(seen: () -> Boolean) = wake(FIRST_REPEAT_MS, seen)

    /** The agent begins to perceive, and so has seen what [wakeIn] woke it for. Called by its thread. */
    fun perceives() {
        perceivedMs = platform.nowMs()
    }

    /** Wakes the agent in [delayMs] ms to perceive, unless it will be woken earlier anyway. */
    fun wakeIn(delayMs: Long) {
        val wait = minOf(delayMs, MAX_DELAY_MS) // who is woken too early looks again
        val at = platform.nowMs() + wait
        if (nextWake.getAndUpdate { minOf(it, at) } <= at) return
        platform.later(wait) {
            nextWake.compareAndSet(at, Long.MAX_VALUE)
            wake(FIRST_REPEAT_MS) { perceivedMs >= at }
        }
    }

    private fun wake(repeatMs: Long, seen: () -> Boolean) {
        if (!arch.isRunning) return
        arch.firstAgArch.wakeUpSense()
        arch.firstAgArch.wakeUpDeliberate()
        arch.firstAgArch.wake() // JADE's architecture knows this call alone
        if (repeatMs <= LAST_REPEAT_MS) platform.later(repeatMs) { if (!seen()) wake(2 * repeatMs, seen) }
    }

    private companion object {
        const val FIRST_REPEAT_MS = 1L
        const val LAST_REPEAT_MS = 1024L
        const val MAX_DELAY_MS = 86_400_000L
    }
}
