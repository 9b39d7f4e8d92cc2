package argo.platform

import javino.LineClock
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit

/** The machine, but for its time, which the test advances. */
internal class TestTime : Platform by Platform.system {
    private class Due(val atMs: Long, val action: () -> Unit)

    private val dues = LinkedBlockingQueue<Due>()

    @Volatile
    private var nowMs = 0L

    override val clock = object : LineClock by LineClock.system() {
        override fun nanos() = TimeUnit.MILLISECONDS.toNanos(nowMs)
    }

    override fun later(delayMs: Long, action: () -> Unit) {
        dues += Due(nowMs + delayMs, action)
    }

    /** Lets [ms] pass, without the work that is due meanwhile. */
    fun pass(ms: Long) {
        nowMs += ms
    }

    /** Does the work that is due next, and waits if there is none yet: other threads may be about to add it. */
    fun step() {
        val due = checkNotNull(dues.poll(20, TimeUnit.SECONDS)) { "nothing is due" }
        nowMs = maxOf(nowMs, due.atMs)
        due.action()
    }

    /** [step], unless nothing is due. */
    fun stepIfDue() {
        if (!isIdle()) step()
    }

    fun isIdle() = dues.isEmpty()

    /** Returns the time of the oldest pending work; there is some. */
    fun nextMs(): Long = dues.element().atMs
}
