package argo

import jason.architecture.AgArch
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal

/**
 * Filters what an agent without [Arch] perceives of its Jason environment. `argo.change_filter` puts it in front of the
 * agent's architectures when the agent chooses a filter for the first time.
 */
internal class EnvironmentFilter private constructor(perceivedSoFar: Collection<Literal>) : AgArch() {
    private val environment = EnvironmentPercepts(perceivedSoFar)

    private var filter = ActiveFilter.NONE
    private var filterIsNew = false

    /** Perceives through [filter] from the next perception on. Called by the agent's thread. */
    fun perceiveThrough(filter: ActiveFilter) {
        this.filter = filter
        filterIsNew = true
    }

    override fun perceive(): MutableCollection<Literal>? {
        val news = environment.update(super.perceive())
        if (!news && !filterIsNew) return null
        filterIsNew = false
        return environment.through(filter).toMutableList()
    }

    override fun canSleep(): Boolean = !filterIsNew && super.canSleep()

    companion object {
        /** Puts a filter in front of the agent of [ts], which must not have one. Called by the agent's thread. */
        fun insertInto(ts: TransitionSystem): EnvironmentFilter {
            // unfiltered so far, so its percept beliefs are what its environment said last
            val perceived = ts.ag.bb.percepts.asSequence().filter { it.subjectToBUF() }.toList()
            return EnvironmentFilter(perceived).also { ts.agArch.insertAgArch(it) }
        }
    }
}
