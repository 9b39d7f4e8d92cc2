package argo.platform

import javino.LineClock
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit

/** The machine, but for its time, which passes when it is told to. */
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

    /** Lets [ms] pass; what is due meanwhile is not done. */
    fun pass(ms: Long) {
        nowMs += ms
    }

    /** Does what is due next, once something is; other threads may be about to say so. */
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

    /** When the next is due that was asked for first; there is one. */
    fun nextMs(): Long = dues.element().atMs
}
