package argo.recording.agent

import argo.platform.SchedulerLayer
import java.util.concurrent.Callable
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.TimeUnit

/** Replaces Jason's scheduler: passes the timers that an agent begins in its cycle to its [Keeper], and all others to Jason's scheduler. */
internal class KeptTimers private constructor(below: ScheduledExecutorService) : SchedulerLayer(below) {
    override fun <V : Any?> later(work: Callable<V>, delay: Long, unit: TimeUnit): ScheduledFuture<V> {
        val keeper = Keeper.current ?: return below.schedule(work, delay, unit)
        return keeper.timer(work, unit.toNanos(delay)) { below.schedule(it, delay, unit) }
    }

    override fun execute(command: Runnable) = below.execute(command) // work without a delay is no timer

    companion object {
        fun install() = install(KeptTimers::class.java, Place.AGENT, ::KeptTimers)
    }
}
