package argo.recording.agent

import argo.insides.Insides
import jason.asSemantics.TransitionSystem
import jason.util.RunnableSerializable
import java.util.concurrent.Callable
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.ScheduledFuture

/** Who keeps what an agent begins outside of its thread, until it is carried out in one of its cycles: a recorder or a replay. */
internal interface Keeper {
    /** The agent begins a timer that does [work] [delayNs] from now; [schedule] has the scheduler do something at that time. */
    fun <V> timer(work: Callable<V>, delayNs: Long, schedule: (Callable<V>) -> ScheduledFuture<V>): ScheduledFuture<V>

    /** Another thread leaves [work] for the beginning of the agent's next cycle. Any thread. */
    fun left(work: RunnableSerializable)

    companion object {
        private val CURRENT = ThreadLocal<Keeper?>()

        /** The keeper of the agent whose cycle the calling thread carries out; null: it carries out none. */
        var current: Keeper?
            get() = CURRENT.get()
            set(keeper) = if (keeper == null) CURRENT.remove() else CURRENT.set(keeper)

        /** A cycle of the agent of [ts] begins. If it perceives nothing in it, [keeper] is the current one at once. */
        fun begin(keeper: Keeper, ts: TransitionSystem) {
            val every = ts.settings.nrcbp()
            if (every > 1 && Insides.cyclesUnperceived[ts] < every) current = keeper
        }

        /** Does [work] as the agent of [keeper] does it, whose cycle has not begun yet. */
        inline fun <T> within(keeper: Keeper, work: () -> T): T {
            current = keeper
            try {
                return work()
            } finally {
                current = null
            }
        }
    }
}

/** The work that waits for the beginning of an agent's next cycle: its own, and what [keeper] lets in of other threads' */
internal class KeptTasks(private val keeper: Keeper) : ConcurrentLinkedQueue<RunnableSerializable>() {
    override fun offer(task: RunnableSerializable): Boolean {
        if (Keeper.current === keeper || task.javaClass.name.startsWith("argo.")) return super.offer(task)
        keeper.left(task)
        return true
    }

    /** A program may write its agent: without the recorder. */
    private fun writeReplace(): Any = ConcurrentLinkedQueue(this)

    companion object {
        /** Puts it in the place of the queue of [ts]; what waits there stays. */
        fun insertInto(ts: TransitionSystem, keeper: Keeper) {
            val waiting = Insides.tasks[ts].toList()
            Insides.tasks[ts] = KeptTasks(keeper).also { tasks -> waiting.forEach(tasks::add) }
        }
    }
}
