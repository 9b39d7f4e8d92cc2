package argo.platform

import jason.architecture.AgArch
import java.util.concurrent.atomic.AtomicLong

/**
 * Wakes an agent that sleeps or is about to sleep. Jason loses a wake-up that comes between an agent's decision to sleep and its sleep,
 * which lasts up to a second. To prevent this loss, an agent asks [maySleep], which returns false after an earlier wake-up. If an agent has
 * decided to sleep but does not sleep yet, it is woken again at growing intervals, until it has seen the reason. An agent that does not ask
 * [maySleep] is also woken repeatedly.
 */
internal class Waker(private val arch: AgArch, private val platform: Platform = Platform.system) {
    private val nextWake = AtomicLong(Long.MAX_VALUE)

    @Volatile
    private var perceivedMs = Long.MIN_VALUE

    /**
     * True if the agent was woken since it last began to perceive. [wake] writes [isWoken], then reads [sleeper]. [maySleep] writes
     * [sleeper], then reads [isWoken].
     */
    @Volatile
    private var isWoken = false

    /** The thread that was allowed to sleep since the last perception began, or null. */
    @Volatile
    private var sleeper: Thread? = null

    @Volatile
    private var perceiver: Thread? = null

    /** The thread that carries out a cycle of the agent; null outside of cycles. */
    @Volatile
    private var reasoner: Thread? = null

    /** True if one thread perceives and sleeps, false for Jason's agents with three threads, null if this is not known yet. */
    @Volatile
    private var isOneThread: Boolean? = null

    /**
     * Wakes the agent now. If this wake-up may be lost, wakes the agent again until [seen] returns true. Other threads call [seen]. If the
     * calling thread carries out the agent's cycle, only prevents this thread from falling asleep after the cycle.
     */
    fun wake(seen: () -> Boolean) {
        if (Thread.currentThread() === reasoner) isWoken = true else wake(FIRST_REPEAT_MS, seen)
    }

    /** True if the calling thread carries out a cycle of the agent. */
    val isInCycle: Boolean get() = Thread.currentThread() === reasoner

    fun cycleStarts() {
        reasoner = Thread.currentThread()
    }

    fun cycleEnds() {
        reasoner = null
    }

    /** Notes that the agent begins to perceive, and so sees why it was woken. Called by the agent's thread. */
    fun perceives() {
        perceivedMs = platform.nowMs()
        perceiver = Thread.currentThread()
        sleeper = null
        isWoken = false
    }

    /**
     * Returns true if the agent was not woken since it last began to perceive. When the agent's thread decides whether to sleep, it calls
     * this function last.
     */
    fun maySleep(): Boolean {
        val thread = Thread.currentThread()
        if (isOneThread != false) isOneThread = thread === perceiver
        sleeper = thread
        if (isOneThread == false || !isWoken) return true
        sleeper = null
        return false
    }

    /**
     * Notes that the agent sleeps next without a call of [maySleep], since an atomic plan waits. Called by the agent's thread after a
     * cycle.
     */
    fun sleepsUnasked() {
        sleeper = Thread.currentThread()
        if (isWoken) wake(FIRST_REPEAT_MS) { !isWoken }
    }

    /** Wakes the agent in [delayMs] ms to perceive. Does nothing if an earlier wake-up is due. */
    fun wakeIn(delayMs: Long) {
        val wait = minOf(delayMs, MAX_DELAY_MS) // an agent that wakes too early decides again whether to sleep
        val at = platform.nowMs() + wait
        if (nextWake.getAndUpdate { minOf(it, at) } <= at) return
        platform.later(wait) {
            nextWake.compareAndSet(at, Long.MAX_VALUE)
            wake(FIRST_REPEAT_MS) { perceivedMs >= at }
        }
    }

    private fun wake(repeatMs: Long, seen: () -> Boolean) {
        if (!arch.isRunning) return
        isWoken = true
        val isInVain = mayBeInVain()
        arch.firstAgArch.wakeUpSense()
        arch.firstAgArch.wakeUpDeliberate()
        arch.firstAgArch.wake() // JADE's architecture knows only this call
        if (isInVain && repeatMs <= LAST_REPEAT_MS) platform.later(repeatMs) { if (!seen()) wake(2 * repeatMs, seen) }
    }

    /** Returns true if the agent may be about to sleep. A thread that waits with a time limit is already asleep. */
    private fun mayBeInVain() = isOneThread != true || sleeper.let { it != null && it.state != Thread.State.TIMED_WAITING }

    private companion object {
        const val FIRST_REPEAT_MS = 1L
        const val LAST_REPEAT_MS = 1024L
        const val MAX_DELAY_MS = 86_400_000L
    }
}
