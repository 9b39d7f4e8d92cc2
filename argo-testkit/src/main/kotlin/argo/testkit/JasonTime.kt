package argo.testkit

import argo.platform.SchedulerLayer
import java.util.concurrent.Callable
import java.util.concurrent.Delayed
import java.util.concurrent.FutureTask
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.TimeUnit

/** Jason's scheduler for `.wait` and `.at`. Uses virtual time for agents under test and real time for others. */
internal class JasonTime private constructor(machine: ScheduledExecutorService) : SchedulerLayer(machine) {
    override fun <V : Any?> later(work: Callable<V>, delay: Long, unit: TimeUnit): ScheduledFuture<V> {
        val time = VirtualTime.active() ?: return below.schedule(work, delay, unit)
        return VirtualTask(time, work, unit.toNanos(delay))
    }

    private class VirtualTask<V>(private val time: VirtualTime, work: Callable<V>, delayNanos: Long) :
        FutureTask<V>(work),
        ScheduledFuture<V> {
        private val atNanos = time.nanos() + delayNanos
        private val takeBack = time.later(delayNanos, ::run)

        override fun getDelay(unit: TimeUnit): Long = unit.convert(atNanos - time.nanos(), TimeUnit.NANOSECONDS)

        override fun compareTo(other: Delayed): Int = getDelay(TimeUnit.NANOSECONDS).compareTo(other.getDelay(TimeUnit.NANOSECONDS))

        override fun done() = takeBack()
    }

    companion object {
        fun install() = install(JasonTime::class.java, Place.TIME, ::JasonTime)
    }
}
