package argo.filters.jason

import argo.filters.PerceptionFilter
import argo.filters.matching.CriticalPercept
import argo.filters.matching.Explanation
import argo.filters.matching.FilterSession
import argo.filters.matching.FilteredPercepts
import argo.filters.matching.perceptsOf
import jason.asSyntax.Literal

/**
 * Turns a board's messages into percepts: splits a message, filters the texts, reads the kept ones, and limits how many of them the agent
 * believes.
 *
 * The caller gives the time, in milliseconds of any clock that never goes back. Not safe for use by several threads at once.
 *
 * @param read returns the literals in a percept's text; none if it refuses the text
 * @param limit selects the percepts that the agent is to believe from the kept ones (first argument) and the critical ones (second)
 */
class MessageSession(
    private val read: (String) -> List<Literal>,
    private val limit: (kept: List<Literal>, critical: List<Literal>) -> List<Literal> = { kept, _ -> kept },
) {
    private val session = FilterSession.ofTexts()

    /** The active filter, or null: everything is kept. */
    val filter: PerceptionFilter?
        get() = session.filter

    /** Makes [filter] the active one from the next perception on, as [FilterSession.switchTo]; null: none. */
    fun switchTo(filter: PerceptionFilter?): Unit = session.switchTo(filter)

    /** Returns the part of [message] that the agent perceives at [nowMs]. */
    fun perceive(message: String, nowMs: Long): MessagePerception = perceive(perceptsOf(message), nowMs)

    /**
     * Returns the part that the agent perceives of a message that has been split into the texts of its percepts.
     *
     * @param old the texts of percepts whose sensors have not been read since the last message, as for [FilterSession.perceive]
     */
    fun perceive(texts: List<String>, nowMs: Long, old: Set<String> = emptySet()): MessagePerception =
        literals(session.perceive(texts, nowMs, old))

    /** Forgets what was before, as [FilterSession.forget]. */
    fun forget(): Unit = session.forget()

    /** Returns the last message with the held-back percepts that are due at [nowMs]; null if no percept is due. */
    fun due(nowMs: Long): MessagePerception? = session.due(nowMs)?.let(::literals)

    /** Explains why the filter would keep, drop or hold back the percept [text] at [nowMs], without doing it. */
    fun explain(text: String, nowMs: Long): Explanation = session.explain(text, nowMs)

    private fun literals(texts: FilteredPercepts<String>): MessagePerception {
        val critical = texts.critical.flatMap { found -> read(found.percept).map { CriticalPercept(found.rule, it) } }
        val unreadable = LinkedHashSet<String>()
        val believable = texts.kept.flatMap { text -> read(text).also { if (it.isEmpty()) unreadable += text } }
        val percepts = limit(believable, critical.map { it.percept })
        val seen = if (texts.seen === texts.kept) percepts else texts.seen.flatMap(read)
        return MessagePerception(texts, percepts, seen, critical, unreadable)
    }
}

/**
 * The percepts of one message that reach an agent.
 *
 * @property texts the same percepts as texts: those received, those that the filter kept, and when the next held-back one is due
 * @property percepts the literals that the agent is to believe: kept, readable, and within the limit
 * @property seen the literals of the message's own percepts that the filter let through
 * @property critical the percepts that meet critical rules, once for each such rule
 * @property unreadable the kept texts of which no part could be read
 */
class MessagePerception internal constructor(
    val texts: FilteredPercepts<String>,
    val percepts: List<Literal>,
    val seen: List<Literal>,
    val critical: List<CriticalPercept<Literal>>,
    val unreadable: Set<String>,
)
