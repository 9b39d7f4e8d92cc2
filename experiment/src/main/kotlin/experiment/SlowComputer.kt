package experiment

import jason.architecture.AgArch
import java.lang.management.ManagementFactory
import java.util.concurrent.locks.LockSupport

/**
 * Accounts for the time that a slower computer would need in addition: the time of each reasoning cycle there beyond its time here. A time
 * too short to wait for is carried over.
 *
 * @param factor the ratio by which the other computer is slower, at least 1
 */
internal class SlowTime(private val factor: Double) {
    private var owed = 0.0

    init {
        require(factor >= 1) { "an agent can be slowed down, not sped up: the factor is at least 1, not $factor" }
    }

    /** Adds a cycle that took [cpuNanos] of this computer's time; returns the ns to wait now. */
    fun owedAfter(cpuNanos: Long): Long {
        owed += cpuNanos * (factor - 1)
        return if (owed >= MIN_WAIT_NANOS) owed.toLong() else 0
    }

    /** Subtracts [nanos] ns that have been waited. */
    fun paid(nanos: Long) {
        owed -= nanos
    }

    companion object {
        /** Machines cannot wait for a shorter time with any accuracy. */
        const val MIN_WAIT_NANOS = 200_000L
    }
}

/**
 * Slows the reasoning of an agent: each cycle takes [factor] times the processor time that it took. Time in which the agent's thread
 * waits, for its line above all, is not stretched.
 */
internal class SlowComputer(factor: Double) : AgArch() {
    private val time = SlowTime(factor)
    private val threads = ManagementFactory.getThreadMXBean()
    private var cpuBefore: Long? = null

    override fun reasoningCycleFinished() {
        super.reasoningCycleFinished()
        val cpu = threads.currentThreadCpuTime
        val wait = time.owedAfter(cpu - (cpuBefore ?: cpu))
        if (wait > 0) {
            val start = System.nanoTime()
            LockSupport.parkNanos(wait)
            time.paid(System.nanoTime() - start)
        }
        cpuBefore = threads.currentThreadCpuTime
    }
}
