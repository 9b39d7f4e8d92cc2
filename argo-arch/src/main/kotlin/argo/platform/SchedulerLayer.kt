package argo.platform

import argo.insides.Insides
import jason.asSemantics.Agent
import java.util.concurrent.Callable
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.TimeUnit

/**
 * A scheduler in front of Jason's scheduler, which `.wait`, `.at` and others use. The order of several layers is given by their [Place],
 * not by the order of their installation. [below] is the next lower layer.
 */
abstract class SchedulerLayer(protected val below: ScheduledExecutorService) : ScheduledExecutorService by below {
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

    /** The place of a layer in the stack, from the bottom. */
    enum class Place {
        /** The layer that decides when a timer ends, directly above Jason's scheduler. */
        TIME,

        /** The layer that sees each timer of an agent. This layer is above the layers that end timers. */
        AGENT,
    }

    companion object {
        private class Installed(
            val kind: Class<out SchedulerLayer>,
            val place: Place,
            val make: (ScheduledExecutorService) -> SchedulerLayer,
        )

        private var installed = listOf<Installed>()

        /**
         * Puts a layer at its [place] above Jason's scheduler, for all agents of this program. If a layer of [kind] is installed, does
         * nothing. [make] returns the layer above a given scheduler. A layer has no state, so [make] may be called again when another layer
         * is installed.
         *
         * @throws IllegalStateException if this version of Jason keeps its scheduler elsewhere
         */
        @Synchronized
        fun install(kind: Class<out SchedulerLayer>, place: Place, make: (ScheduledExecutorService) -> SchedulerLayer) {
            if (installed.any { it.kind == kind }) return
            val all = (installed + Installed(kind, place, make)).sortedBy { it.place }
            val top = all.fold(machine()) { below, layer -> layer.make(below) }
            try {
                Insides.scheduler[null] = top
            } catch (other: LinkageError) {
                throw IllegalStateException("this version of Jason keeps its scheduler elsewhere, so .wait cannot be followed", other)
            }
            installed = all
        }

        /** Jason's own scheduler, below all layers. */
        internal fun machine(): ScheduledExecutorService =
            generateSequence(Agent.getScheduler()) { (it as? SchedulerLayer)?.below }.last()
    }
}
