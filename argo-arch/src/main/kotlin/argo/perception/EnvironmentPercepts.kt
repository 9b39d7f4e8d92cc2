package argo.perception

import argo.filters.PerceptionFilter
import argo.filters.jason.literalSession
import jason.asSyntax.Literal

/**
 * An agent's percepts from its Jason environment, through its active filter. An environment returns nothing if nothing has changed, so this
 * keeps the last result. Belongs to the agent's thread.
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

    /** Perceives through [filter] from the next perception on; null: everything. */
    fun switchTo(filter: PerceptionFilter?) {
        session.switchTo(filter)
        dueMs = null
        filterIsNew = true
    }

    /** Takes the result of the next architecture's `perceive()`; null: no news. Returns true if [percepts] may have changed. */
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

    /** Returns the ms until a held-back percept is due; null: none is held back. */
    fun dueInMs(): Long? = dueMs?.let { maxOf(0, it - nowMs()) }

    /** Returns true if [update] has something to do even without news. */
    fun isWaiting(): Boolean = filterIsNew || dueInMs() == 0L

    fun explain(percept: Literal): String = session.explain(percept, nowMs()).toString()
}
