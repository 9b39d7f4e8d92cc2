package argo.perception

import argo.filters.PerceptionFilter
import argo.platform.Platform
import argo.platform.Waker
import argo.platform.nowMs
import jason.architecture.AgArch
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal

/**
 * Filters the percepts that an agent without `argo.Arch` gets from its Jason environment. The agent's first call of `argo.change_filter`
 * inserts this architecture in front of the agent's other architectures.
 */
internal class EnvironmentFilter private constructor(perceivedSoFar: Collection<Literal>) : AgArch() {
    private val environment = EnvironmentPercepts(perceivedSoFar, Platform.system.nowMs)
    private val waker = Waker(this)

    /** Uses [filter] from the next perception on. If [filter] is null, every percept passes. Called by the agent's thread. */
    fun perceiveThrough(filter: PerceptionFilter?) = environment.switchTo(filter)

    fun explain(percept: Literal): String = environment.explain(percept)

    override fun perceive(): MutableCollection<Literal>? {
        waker.perceives()
        val isNew = environment.update(super.perceive())
        environment.dueInMs()?.let(waker::wakeIn)
        return if (isNew) environment.percepts.toMutableList() else null
    }

    override fun canSleep(): Boolean = !environment.isWaiting() && super.canSleep()

    companion object {
        /**
         * Inserts a filter in front of the architectures of the agent of [ts], which must not have a filter yet. Called by the agent's
         * thread.
         */
        fun insertInto(ts: TransitionSystem): EnvironmentFilter {
            // without a filter, the agent's percept beliefs are the environment's last result
            val perceived = ts.ag.bb.percepts.asSequence().filter { it.subjectToBUF() }.toList()
            return EnvironmentFilter(perceived).also { ts.agArch.insertAgArch(it) }
        }
    }
}
