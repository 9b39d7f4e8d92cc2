package argo.filters.jason

import argo.filters.PerceptionFilter
import argo.filters.matching.CriticalPercept
import argo.filters.matching.Explanation
import argo.filters.matching.FilterSession
import argo.filters.matching.FilteredPercepts
import argo.filters.matching.perceptsOf
import jason.asSyntax.Literal

/**
 * Turns a board's messages into percepts. Splits a message into texts, filters them, reads the kept texts, and limits their number.
 *
 * The caller passes the time in milliseconds of a clock that never goes back. Not thread-safe.
 *
 * @param read returns the literals in a percept's text, or none if the text cannot be read
 * @param limit gets the kept and the critical percepts, and returns those that the agent is to believe
 */
class MessageSession(
    private val read: (String) -> List<Literal>,
    private val limit: (kept: List<Literal>, critical: List<Literal>) -> List<Literal> = { kept, _ -> kept },
) {
    private val session = FilterSession.ofTexts()

    /** The active filter. Null: all percepts are kept. */
    val filter: PerceptionFilter?
        get() = session.filter

    /** Makes [filter] the active filter from the next perception on, like [FilterSession.switchTo]. Null: no filter. */
    fun switchTo(filter: PerceptionFilter?): Unit = session.switchTo(filter)

    /** Returns the agent's perception of [message] at [nowMs]. */
    fun perceive(message: String, nowMs: Long): MessagePerception = perceive(perceptsOf(message), nowMs)

    /**
     * Returns the agent's perception of a message that has been split into the [texts] of its percepts.
     *
     * @param old the texts of percepts whose sensors were not read since the last message; see [FilterSession.perceive]
     */
    fun perceive(texts: List<String>, nowMs: Long, old: Set<String> = emptySet()): MessagePerception =
        literals(session.perceive(texts, nowMs, old))

    /** Forgets earlier percepts, like [FilterSession.forget]. */
    fun forget(): Unit = session.forget()

    /** Returns the last message with the held-back percepts that are due at [nowMs]. Returns null if no percept is due. */
    fun due(nowMs: Long): MessagePerception? = session.due(nowMs)?.let(::literals)

    /** Explains why the filter would keep, drop or hold back the percept [text] at [nowMs]. Changes nothing. */
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
 * @property texts the percepts as texts, and the time at which the next held-back percept is due
 * @property percepts the literals that the agent is to believe: those that are kept, readable and within the limit
 * @property seen the literals of the message's percepts that the filter let through
 * @property critical the percepts that meet critical rules, once for each such rule
 * @property unreadable the kept texts that contain no readable literal
 */
class MessagePerception internal constructor(
    val texts: FilteredPercepts<String>,
    val percepts: List<Literal>,
    val seen: List<Literal>,
    val critical: List<CriticalPercept<Literal>>,
    val unreadable: Set<String>,
)
