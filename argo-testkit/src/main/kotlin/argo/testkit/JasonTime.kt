package argo.testkit

import jason.asSemantics.Agent
import java.util.concurrent.Callable
import java.util.concurrent.Delayed
import java.util.concurrent.FutureTask
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.TimeUnit

/**
 * Jason's scheduler, which `.wait` and `.at` use: in virtual time for agents under test, in real time for all others.
 */
internal class JasonTime private constructor(private val machine: ScheduledExecutorService) : ScheduledExecutorService by machine {
    override fun schedule(command: Runnable, delay: Long, unit: TimeUnit): ScheduledFuture<*> =
        schedule(Callable { command.run() }, delay, unit)

    override fun <V : Any?> schedule(callable: Callable<V>, delay: Long, unit: TimeUnit): ScheduledFuture<V> {
        val time = VirtualTime.active() ?: return machine.schedule(callable, delay, unit)
        return VirtualTask(time, callable, unit.toNanos(delay))
    }

    override fun execute(command: Runnable) {
        schedule(command, 0, TimeUnit.NANOSECONDS)
    }

    override fun <T : Any?> submit(task: Callable<T>) = schedule(task, 0, TimeUnit.NANOSECONDS)

    override fun submit(task: Runnable) = schedule(task, 0, TimeUnit.NANOSECONDS)

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
        /** Puts it in the place of Jason's scheduler, once for all agents of this program. */
        @Synchronized
        fun install() {
            val machine = Agent.getScheduler()
            if (machine is JasonTime) return
            try {
                // Jason has no other way to give it one
                Agent::class.java.getDeclaredField("scheduler").apply { isAccessible = true }.set(null, JasonTime(machine))
            } catch (other: ReflectiveOperationException) {
                throw IllegalStateException(
                    "this version of Jason keeps its scheduler elsewhere, so .wait cannot go by the test's time", other,
                )
            }
        }
    }
}
