package argo.perception

import argo.filters.PerceptionFilter
import argo.filters.jason.literalSession
import jason.asSyntax.Literal

/**
 * The percepts that an agent gets from its Jason environment through its active filter. An environment returns null if nothing has changed,
 * so this object keeps the last result. For the agent's thread only.
 *
 * @param known the last known result of the environment
 * @param nowMs a clock in ms that never goes back
 */
internal class EnvironmentPercepts(known: Collection<Literal> = emptyList(), private val nowMs: () -> Long) {
    private val session = literalSession()
    private var last: List<Literal> = known.toList()
    private var filterIsNew = false
    private var dueMs: Long? = null

    /** The percepts that the agent perceives now. */
    var percepts: List<Literal> = last
        private set

    /** Uses [filter] from the next perception on. If [filter] is null, every percept passes. */
    fun switchTo(filter: PerceptionFilter?) {
        session.switchTo(filter)
        dueMs = null
        filterIsNew = true
    }

    /** Takes in [news] from the next architecture's `perceive()`; null if nothing is new. Returns true if [percepts] may have changed. */
    fun update(news: Collection<Literal>?): Boolean {
        if (news != null) last = news.toList()
        val now = if (news != null || filterIsNew) session.perceive(last, nowMs()) else session.due(nowMs())
        filterIsNew = false
        if (now != null) {
            percepts = now.kept
            dueMs = now.nextDueMs
        }
        return now != null
    }

    /** Returns the ms until a held-back percept is due; null if none is held back. */
    fun dueInMs(): Long? = dueMs?.let { maxOf(0, it - nowMs()) }

    /** Returns true if a call of [update] without news may change [percepts]. */
    fun isWaiting(): Boolean = filterIsNew || dueInMs() == 0L

    fun explain(percept: Literal): String = session.explain(percept, nowMs()).toString()
}
