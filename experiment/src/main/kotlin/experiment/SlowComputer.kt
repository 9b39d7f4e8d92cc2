package experiment

import jason.architecture.AgArch
import java.lang.management.ManagementFactory
import java.util.concurrent.Semaphore
import java.util.concurrent.locks.LockSupport

/**
 * Sums up the extra time of a computer that is [factor] times slower than this one. The extra time is the difference of a cycle's time
 * there and here. A time that is too short for a wait is added to the next one. [factor] is at least 1.
 */
internal class SlowTime(private val factor: Double) {
    private var owed = 0.0

    init {
        require(factor >= 1) { "an agent can be slowed down, not sped up: the factor is at least 1, not $factor" }
    }

    /** Adds a cycle that took [cpuNanos] of processor time on this computer. Returns the time to wait now, in ns. */
    fun owedAfter(cpuNanos: Long): Long {
        owed += cpuNanos * (factor - 1)
        return if (owed >= MIN_WAIT_NANOS) owed.toLong() else 0
    }

    fun paid(nanos: Long) {
        owed -= nanos
    }

    companion object {
        /** A computer cannot wait accurately for a shorter time. */
        const val MIN_WAIT_NANOS = 200_000L
    }
}

/**
 * Slows an agent's reasoning. Each cycle takes [factor] times its processor time. Waiting times of the agent's thread, mostly for its line,
 * do not change.
 *
 * @param processors the processors that the agents of the slow computer share. A cycle occupies one of them
 */
internal class SlowComputer(private val factor: Double, private val processors: Semaphore = Semaphore(1)) : AgArch() {
    private val time = SlowTime(factor)
    private val threads = ManagementFactory.getThreadMXBean()
    private var cpuBefore: Long? = null

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
