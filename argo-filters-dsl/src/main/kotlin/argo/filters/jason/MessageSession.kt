package argo.filters.jason

import argo.filters.PerceptionFilter
import argo.filters.matching.CriticalPercept
import argo.filters.matching.Explanation
import argo.filters.matching.FilterSession
import argo.filters.matching.FilteredPercepts
import argo.filters.matching.perceptsOf
import jason.asSyntax.Literal

/**
 * Makes percepts of a board's messages: splits a message, filters the texts, reads what is kept, and limits how much of it the agent
 * believes.
 *
 * Time is the caller's: milliseconds of any clock that never goes back. Not safe for use by several threads at once.
 *
 * @param read the literals of a percept's text, none if it is refused
 * @param limit what the agent is to believe of the kept percepts, the first argument; the second are the critical ones
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

    /** What the agent perceives of [message] at [nowMs]. */
    fun perceive(message: String, nowMs: Long): MessagePerception = perceive(perceptsOf(message), nowMs)

    /** As the other form, of a message that has been split into the texts of its percepts. */
    fun perceive(texts: List<String>, nowMs: Long): MessagePerception = literals(session.perceive(texts, nowMs))

    /** The last message with the held-back percepts that are due at [nowMs]; null if none is. */
    fun due(nowMs: Long): MessagePerception? = session.due(nowMs)?.let(::literals)

    /** Why the filter would keep, drop or hold back the percept [text] at [nowMs], without doing it. */
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
 * What an agent perceives of one message.
 *
 * @property texts the same as texts: what came, what the filter kept, and when something that it holds back is due
 * @property percepts what the agent is to believe: what was kept and could be read, as far as the limit allows
 * @property seen the literals of those percepts that the message holds and the filter let through
 * @property critical the percepts that critical rules meet, once for each such rule
 * @property unreadable the texts that were kept and of which nothing could be read
 */
class MessagePerception internal constructor(
    val texts: FilteredPercepts<String>,
    val percepts: List<Literal>,
    val seen: List<Literal>,
    val critical: List<CriticalPercept<Literal>>,
    val unreadable: Set<String>,
)
