package argo.perception

import argo.filters.PerceptionFilter
import argo.filters.jason.literalSession
import jason.asSyntax.Literal

/**
 * What an agent perceives of its Jason environment, through its active filter. An environment returns nothing when nothing has
 * changed, so its last word is kept. Belongs to the agent's thread.
 *
 * @param known what the environment returned last, as far as it is known
 * @param nowMs a clock in ms that never goes back
 */
internal class EnvironmentPercepts(known: Collection<Literal> = emptyList(), private val nowMs: () -> Long) {
    private val session = literalSession()
    private var last: List<Literal> = known.toList()
    private var filterIsNew = false
    private var dueMs: Long? = null

    /** What of it the agent perceives now. */
    var percepts: List<Literal> = last
        private set

    /** Perceives through [filter] from the next perception on; null: everything. */
    fun switchTo(filter: PerceptionFilter?) {
        session.switchTo(filter)
        dueMs = null
        filterIsNew = true
    }

    /** Takes what the next architecture's `perceive()` returned, null being no news; returns whether [percepts] may have changed. */
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

    /** In how many ms a percept that the filter holds back is due; null if none is held back. */
    fun dueInMs(): Long? = dueMs?.let { maxOf(0, it - nowMs()) }

    /** Whether [update] has something to do even without news. */
    fun isWaiting(): Boolean = filterIsNew || dueInMs() == 0L

    /** Why the active filter does with [percept] what it does. */
    fun explain(percept: Literal): String = session.explain(percept, nowMs()).toString()
}
