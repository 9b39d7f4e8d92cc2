package argo

import jason.asSyntax.Literal

/**
 * What the agent perceives of its Jason environment. An environment says nothing when nothing has changed, so its last
 * word is kept, and seen through whatever filter is active now. Belongs to the agent's thread.
 */
internal class EnvironmentPercepts(known: Collection<Literal> = emptyList()) {
    private var last: Collection<Literal> = ArrayList(known)

    /** Takes what the next architecture's `perceive()` returned; null changes nothing. Returns whether it was news. */
    fun update(percepts: Collection<Literal>?): Boolean {
        if (percepts != null) last = ArrayList(percepts)
        return percepts != null
    }

    /** What of it passes [filter]. */
    fun through(filter: ActiveFilter): List<Literal> = last.filterNot { filter.drops(it) }
}
