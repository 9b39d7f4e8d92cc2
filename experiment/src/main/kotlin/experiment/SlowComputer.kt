package experiment

import jason.architecture.AgArch
import java.lang.management.ManagementFactory
import java.util.concurrent.Semaphore
import java.util.concurrent.locks.LockSupport

/**
 * Adds up the additional time of a computer that is [factor] times slower than this one: the difference between a cycle's time there and
 * here. A time that is too short for waiting is added to the next. [factor] is at least 1.
 */
internal class SlowTime(private val factor: Double) {
    private var owed = 0.0

    init {
        require(factor >= 1) { "an agent can be slowed down, not sped up: the factor is at least 1, not $factor" }
    }

    /** Adds a cycle that took [cpuNanos] of processor time on this computer. Returns the ns to wait now. */
    fun owedAfter(cpuNanos: Long): Long {
        owed += cpuNanos * (factor - 1)
        return if (owed >= MIN_WAIT_NANOS) owed.toLong() else 0
    }

    fun paid(nanos: Long) {
        owed -= nanos
    }

    companion object {
        /** A machine cannot wait accurately for a shorter time. */
        const val MIN_WAIT_NANOS = 200_000L
    }
}

/**
 * Slows the reasoning of an agent: each cycle takes [factor] times its processor time. Times in which the agent's thread waits, mostly for
 * its line, stay as they are.
 *
 * @param processors the processors of the slow computer, which its agents share; a cycle occupies one of them
 */
internal class SlowComputer(private val factor: Double, private val processors: Semaphore = Semaphore(1)) : AgArch() {
    private val time = SlowTime(factor)
    private val threads = ManagementFactory.getThreadMXBean()
    private var cpuBefore: Long? = null

    /** The processor time of the agent on the slow computer, in ns. Any thread may ask. */
    @Volatile
    var busyNanos = 0L
        private set

    override fun reasoningCycleStarting() {
        processors.acquireUninterruptibly()
        super.reasoningCycleStarting()
    }

    override fun reasoningCycleFinished() {
        try {
            super.reasoningCycleFinished()
            stretch()
        } finally {
            processors.release()
        }
    }

    private fun stretch() {
        val cpu = threads.currentThreadCpuTime
        val taken = cpu - (cpuBefore ?: cpu)
        busyNanos += (taken * factor).toLong()
        val wait = time.owedAfter(taken)
        if (wait > 0) {
            val start = System.nanoTime()
            LockSupport.parkNanos(wait)
            time.paid(System.nanoTime() - start)
        }
        cpuBefore = threads.currentThreadCpuTime
    }
}
