package argo.platform

import jason.asSemantics.Agent
import java.util.concurrent.Callable
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.TimeUnit

/**
 * A scheduler in the place of Jason's, which `.wait`, `.at` and others use. Several may stand one upon the other; [below] is the next.
 */
abstract class SchedulerLayer(protected val below: ScheduledExecutorService) : ScheduledExecutorService by below {
    /** Does [work] in [delay] of [unit]. */
    protected abstract fun <V : Any?> later(work: Callable<V>, delay: Long, unit: TimeUnit): ScheduledFuture<V>

    final override fun schedule(command: Runnable, delay: Long, unit: TimeUnit): ScheduledFuture<*> =
        later(Callable { command.run() }, delay, unit)

    final override fun <V : Any?> schedule(callable: Callable<V>, delay: Long, unit: TimeUnit): ScheduledFuture<V> =
        later(callable, delay, unit)

    override fun execute(command: Runnable) {
        schedule(command, 0, TimeUnit.NANOSECONDS)
    }

    final override fun <T : Any?> submit(task: Callable<T>) = schedule(task, 0, TimeUnit.NANOSECONDS)

    final override fun submit(task: Runnable) = schedule(task, 0, TimeUnit.NANOSECONDS)

    companion object {
        /**
         * Puts what [make] returns for the scheduler in use in its place, for all agents of this program, unless a layer of [kind] is
         * there.
         * @throws IllegalStateException if this version of Jason keeps its scheduler elsewhere
         */
        @Synchronized
        fun install(kind: Class<out SchedulerLayer>, make: (ScheduledExecutorService) -> SchedulerLayer) {
            val inUse = Agent.getScheduler()
            if (layers(inUse).any(kind::isInstance)) return
            try {
                // Jason has no other way to give it one
                Agent::class.java.getDeclaredField("scheduler").apply { isAccessible = true }.set(null, make(inUse))
            } catch (other: ReflectiveOperationException) {
                throw IllegalStateException("this version of Jason keeps its scheduler elsewhere, so .wait cannot be followed", other)
            }
        }

        /** Jason's own scheduler, below all layers. */
        internal fun machine(): ScheduledExecutorService = layers(Agent.getScheduler()).last()

        private fun layers(top: ScheduledExecutorService) = generateSequence(top) { (it as? SchedulerLayer)?.below }
    }
}
