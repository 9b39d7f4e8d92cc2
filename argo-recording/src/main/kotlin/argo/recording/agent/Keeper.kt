package argo.recording.agent

import argo.insides.Insides
import argo.platform.SchedulerLayer
import jason.asSemantics.TransitionSystem
import jason.util.RunnableSerializable
import java.util.concurrent.Callable
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.TimeUnit

/** Owns an agent's timers, and the work that other threads leave for it. Timers and work run in the agent's cycles. */
internal interface Keeper {
    /** Begins a timer of the agent, which does [work] after [delayNs]. [schedule] makes the scheduler call its argument at that time. */
    fun <V> timer(work: Callable<V>, delayNs: Long, schedule: (Callable<V>) -> ScheduledFuture<V>): ScheduledFuture<V>

    /**
     * Takes [work] that another thread or the project's code leaves for the beginning of the agent's next cycle. Any thread may call this
     * function.
     */
    fun left(work: RunnableSerializable)

    companion object {
        private val CURRENT = ThreadLocal<Keeper?>()

        /** The keeper of the agent that reasons on the calling thread; null if the thread carries out no cycle. */
        var current: Keeper?
            get() = CURRENT.get()
            set(keeper) = if (keeper == null) CURRENT.remove() else CURRENT.set(keeper)

        /**
         * Begins a cycle of the agent of [ts]. If the agent does not perceive in this cycle, [keeper] becomes the [current] keeper at once.
         */
        fun begin(keeper: Keeper, ts: TransitionSystem) {
            val every = ts.settings.nrcbp()
            if (every > 1 && Insides.cyclesUnperceived[ts] < every) current = keeper
        }

        /** Does [work] with [keeper] as the [current] keeper. Used before the agent senses in a cycle. */
        inline fun <T> within(keeper: Keeper, work: () -> T): T {
            val around = current
            current = keeper
            try {
                return work()
            } finally {
                current = around
            }
        }
    }
}

/** The queue of work for the beginning of an agent's next cycle. Work of other threads or of the project's classes goes to [keeper]. */
internal class KeptTasks(private val keeper: Keeper) : ConcurrentLinkedQueue<RunnableSerializable>() {
    override fun offer(task: RunnableSerializable): Boolean {
        val isOwn = task.javaClass.name.startsWith("argo.") || Keeper.current === keeper && JasonActions.isOwn(task.javaClass)
        if (isOwn) return super.offer(task)
        keeper.left(task)
        return true
    }

    private fun writeReplace(): Any = ConcurrentLinkedQueue(this)

    companion object {
        /** Replaces the queue of [ts], and keeps its waiting work. */
        fun insertInto(ts: TransitionSystem, keeper: Keeper) {
            val waiting = Insides.tasks[ts].toList()
            Insides.tasks[ts] = KeptTasks(keeper).also { tasks -> waiting.forEach(tasks::add) }
        }
    }
}

/**
 * Replaces Jason's scheduler. Passes the timers that an agent begins in its cycle to the agent's [Keeper], and all other timers to Jason's
 * scheduler.
 */
internal class KeptTimers private constructor(below: ScheduledExecutorService) : SchedulerLayer(below) {
    override fun <V : Any?> later(work: Callable<V>, delay: Long, unit: TimeUnit): ScheduledFuture<V> {
        val keeper = Keeper.current ?: return below.schedule(work, delay, unit)
        return keeper.timer(work, unit.toNanos(delay)) { below.schedule(it, delay, unit) }
    }

    override fun execute(command: Runnable) = below.execute(command) // an action without a delay is no timer

    companion object {
        fun install() = install(KeptTimers::class.java, Place.AGENT, ::KeptTimers)
    }
}
