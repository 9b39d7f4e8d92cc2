package experiment

import jason.architecture.AgArch
import java.lang.management.ManagementFactory
import java.util.concurrent.locks.LockSupport

/**
 * Owes to a slower computer what this one is faster by: the time that each reasoning cycle would have taken there beyond what it
 * took here. What is too little to wait for is owed on.
 *
 * @param factor how many times slower the other computer is, at least 1
 */
internal class SlowTime(private val factor: Double) {
    private var owed = 0.0

    init {
        require(factor >= 1) { "an agent can be slowed down, not sped up: the factor is at least 1, not $factor" }
    }

    /** A cycle has taken [cpuNanos] of this computer's time; returns the ns to wait now. */
    fun owedAfter(cpuNanos: Long): Long {
        owed += cpuNanos * (factor - 1)
        return if (owed >= MIN_WAIT_NANOS) owed.toLong() else 0
    }

    /** That many ns have been waited. */
    fun paid(nanos: Long) {
        owed -= nanos
    }

    companion object {
        /** Machines do not wait for less with any accuracy. */
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
