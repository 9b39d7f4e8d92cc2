package argo.testkit

import javino.LineClock
import java.util.PriorityQueue
import java.util.concurrent.Semaphore
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.Condition
import java.util.concurrent.locks.Lock

/**
 * A time that goes on only when everything that goes by it waits, and then at once to the end of the shortest wait. One thread of those
 * that it [start]ed runs at a time, always in the same order, so what goes by it gives the same result on any machine.
 *
 * The thread that calls [advance] or [advanceUntil], or waits for a lock or a condition of this time, drives it: the test's. It must be one
 * at a time.
 */
internal class VirtualTime : LineClock {
    private val strands = ArrayList<Strand>()
    private val timers = PriorityQueue<Timer>(compareBy({ it.atNanos }, { it.number }))
    private val returned = Semaphore(0)
    private var nowNanos = 0L
    private var timersSoFar = 0L

    /** Does a part of what else there is to do now, on the driver's thread, and says whether there was anything. */
    var work: () -> Boolean = { false }

    /** Whose agents go by it; null before there are any. */
    var mas: TestMas? = null

    override fun nanos(): Long = nowNanos

    override fun await(condition: Condition, nanos: Long) {
        condition.awaitNanos(nanos)
    }

    override fun newLock(fair: Boolean): Lock = VirtualLock(this)

    /** Starts a thread of this time; it runs when the driver lets it. */
    fun start(name: String, run: () -> Unit): Thread = Strand(name, run).also {
        strands += it
        it.isDaemon = true
        it.start()
    }

    /** Does [action] on the driver's thread in [delayNanos]; it must not wait. Returns what takes it back. */
    fun later(delayNanos: Long, action: () -> Unit): () -> Unit {
        val timer = Timer(nowNanos + maxOf(0, delayNanos), timersSoFar++, action)
        timers += timer
        return { timers -= timer }
    }

    /** Lets [nanos] pass. */
    fun advance(nanos: Long) = advanceUntil(nanos) { false }

    /**
     * Lets time pass until [reached], at most [nanos], and returns whether it was. What there is to do at the end's instant is done.
     * @throws InterruptedException if the driver is interrupted: its test is to end
     */
    fun advanceUntil(nanos: Long, reached: () -> Boolean): Boolean = driving {
        val end = nowNanos + nanos
        while (true) {
            if (Thread.interrupted()) throw InterruptedException("the test was interrupted")
            val rests = settle()
            if (reached()) return@driving true
            if (nowNanos > end) return@driving false // who waits within what it does here has taken the time with it
            if (rests) nowNanos = nextInstant()?.takeIf { it <= end } ?: break
        }
        nowNanos = maxOf(nowNanos, end)
        false
    }

    /** Lets everything run until all that is left waits for a later time, or time has gone on meanwhile: false. */
    fun settle(): Boolean = driving {
        val instant = nowNanos
        var ran = true
        while (ran && nowNanos == instant) ran = runReady() || work()
        !ran
    }

    /** The names of the threads that have not ended. */
    fun living(): List<String> = strands.filter { !it.over }.map { it.name }

    /** Interrupts all threads. */
    fun interruptAll() = strands.forEach { it.interrupt() }

    /** Who runs now: a thread of this time, or null for the driver. */
    val running: Any? get() = Thread.currentThread().let { if (it is Strand && it.time === this) it else null }

    /**
     * Waits until [ready], or until the time is [deadlineNanos] (null: never). Called by who runs.
     * @throws InterruptedException if it may be and was
     */
    fun block(deadlineNanos: Long?, interruptible: Boolean, ready: () -> Boolean) {
        val strand = running as Strand?
        if (strand != null) return strand.block(deadlineNanos, interruptible, ready)
        driving {
            while (!ready() && (deadlineNanos == null || nowNanos < deadlineNanos)) if (!runReady()) {
                val next = listOfNotNull(nextInstant(), deadlineNanos).minOrNull()
                    ?: error("the test waits for something that never comes: ${strands.filter { !it.over }.joinToString { it.name }}")
                nowNanos = maxOf(nowNanos, next)
            }
        }
    }

    /** Runs one thread or timer that is due; false if none is. */
    private fun runReady(): Boolean {
        strands.removeAll { it.over }
        val strand = strands.firstOrNull { it.canRun() }
        if (strand != null) {
            strands -= strand // the others first, before it runs again
            strands += strand
            resume(strand)
            return true
        }
        if ((timers.peek() ?: return false).atNanos > nowNanos) return false
        timers.remove().action()
        return true
    }

    private fun resume(strand: Strand) {
        strand.go.release()
        if (!returns()) {
            val where = strand.stackTrace.joinToString("\n") { "\tat $it" }
            error("thread ${strand.name} waits for something that is not part of the test's time:\n$where")
        }
        strand.failure?.let { throw IllegalStateException("thread ${strand.name} ended with $it", it) }
    }

    /** Whether who runs waits or ends in good time. It is waited for even if the driver is interrupted: nobody runs beside the driver. */
    private fun returns(): Boolean {
        val end = System.nanoTime() + TimeUnit.SECONDS.toNanos(STUCK_S)
        var wasInterrupted = false
        try {
            while (true) {
                try {
                    return returned.tryAcquire(end - System.nanoTime(), TimeUnit.NANOSECONDS)
                } catch (_: InterruptedException) {
                    wasInterrupted = true
                }
            }
        } finally {
            if (wasInterrupted) Thread.currentThread().interrupt()
        }
    }

    /** When something is due next, now at the earliest; null: never. */
    private fun nextInstant(): Long? =
        (strands.mapNotNull { if (it.over) null else it.deadlineNanos } + listOfNotNull(timers.peek()?.atNanos)).minOrNull()?.let { maxOf(it, nowNanos) }

    /** Does [work] as a part of this time: what it starts and logs belongs to it. */
    fun <T> driving(work: () -> T): T {
        val before = ACTIVE.get()
        ACTIVE.set(this)
        try {
            return work()
        } finally {
            ACTIVE.set(before)
        }
    }

    private class Timer(val atNanos: Long, val number: Long, val action: () -> Unit)

    /**
     * A thread that runs only when it is let go, and lets the driver go on when it waits or ends. Who interrupts it while it waits for the
     * driver must not disturb that: it learns of it when it runs again, by its thread's own flag.
     */
    private inner class Strand(name: String, private val body: () -> Unit) : Thread(name) {
        val time get() = this@VirtualTime
        val go = Semaphore(0)
        var deadlineNanos: Long? = null
        private var ready: () -> Boolean = { true }
        private var interruptible = false

        @Volatile
        private var toBeInterrupted = false

        @Volatile
        var over = false

        @Volatile
        var failure: Throwable? = null

        fun canRun() = ready() || deadlineNanos.let { it != null && it <= nowNanos } || interruptible && toBeInterrupted

        override fun run() {
            awaitTurn()
            try {
                body()
            } catch (cause: Throwable) { // the driver throws it
                failure = cause
            } finally {
                over = true
                returned.release()
            }
        }

        fun block(deadlineNanos: Long?, interruptible: Boolean, ready: () -> Boolean) {
            if (interruptible && interrupted()) throw InterruptedException()
            this.deadlineNanos = deadlineNanos
            this.interruptible = interruptible
            this.ready = ready
            returned.release()
            awaitTurn()
            this.deadlineNanos = null
            if (interruptible && interrupted()) throw InterruptedException()
        }

        private fun awaitTurn() {
            go.acquireUninterruptibly()
            if (!toBeInterrupted) return
            toBeInterrupted = false
            super.interrupt()
        }

        override fun interrupt() {
            if (currentThread() === this) super.interrupt() else toBeInterrupted = true
        }

        override fun isInterrupted() = super.isInterrupted() || toBeInterrupted
    }

    companion object {
        private val ACTIVE = ThreadLocal<VirtualTime?>()

        /** The time that the calling thread belongs to or drives; null if it does neither. */
        fun active(): VirtualTime? = (Thread.currentThread() as? Strand)?.time ?: ACTIVE.get()

        /** How long a thread may really take for what takes no time, in s. */
        private const val STUCK_S = 30L
    }
}
