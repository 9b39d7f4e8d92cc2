package argo.platform

import javino.LineClock
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit

/** The machine's platform, but with a time that the test advances. */
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

    /** Advances the time by [ms], without the work that becomes due. */
    fun pass(ms: Long) {
        nowMs += ms
    }

    /** Does the work that is due next. If no work is due yet, waits for another thread to add some. */
    fun step() {
        val due = checkNotNull(dues.poll(20, TimeUnit.SECONDS)) { "nothing is due" }
        nowMs = maxOf(nowMs, due.atMs)
        due.action()
    }

    fun stepIfDue() {
        if (!isIdle()) step()
    }

    fun isIdle() = dues.isEmpty()

    /** Returns the time of the oldest pending work. Fails if there is none. */
    fun nextMs(): Long = dues.element().atMs
}
