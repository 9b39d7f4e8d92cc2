package argo.recording.replay

import argo.filters.PerceptionFilter
import argo.filters.jason.MessagePerception
import argo.filters.jason.MessageSession
import argo.filters.jason.PerceptReader
import argo.perception.whyLeftOut
import argo.recording.Cycle
import argo.recording.PerceivedSnapshot
import argo.recording.agent.literalText
import jason.asSyntax.Atom
import jason.asSyntax.Literal
import java.util.concurrent.TimeUnit

/**
 * The recorded percepts, but with [filter] instead of the recorded filters for the boards' messages. Percepts of an environment and beliefs
 * about ports stay as recorded.
 */
internal class RefilteredPercepts(private val filter: PerceptionFilter) : ReplayedPercepts {
    private val boards = LinkedHashMap<String, Board>()
    private var recorded: List<Literal> = emptyList()
    private var critical: Set<Literal> = emptySet()
    private var newlyCritical: List<Literal> = emptyList()

    override fun begin(percepts: List<Literal>) {
        recorded = percepts
    }

    override fun perceive(cycle: Cycle): List<Literal>? {
        newlyCritical = emptyList()
        val input = cycle.input
        val ms = TimeUnit.NANOSECONDS.toMillis(cycle.ns)
        input.snapshots.forEach { boards.getOrPut(it.port) { Board(it.namespace) }.receive(it, ms) }
        val isDue = boards.values.map { it.takeDue(ms) }.any { it } // `map` first, so that every board takes its due percepts
        input.percepts?.let { recorded = it.appliedTo(recorded) }
        if (input.percepts == null && !isDue) return null
        noteCritical()
        val before = boards.values.flatMapTo(HashSet()) { it.before }
        return boards.values.flatMap { it.now?.percepts.orEmpty() } + recorded.filterNot { literalText(it) in before }
    }

    private fun noteCritical() {
        val now = boards.values.flatMap { it.now?.critical.orEmpty() }.map { it.percept }
        newlyCritical = now.filterNot { it in critical }.distinct()
        critical = now.toSet()
    }

    override fun takeNewlyCritical(): List<Literal> = newlyCritical

    /** A board with percepts in [namespace]; null for the default namespace. */
    private inner class Board(private val namespace: String?) {
        private val session = MessageSession(::read).also { it.switchTo(filter) }

        /** The texts of the board's newest message that the agent perceived in the recording. */
        var before: Set<String> = emptySet()
            private set

        /** The part of the board's newest message that the agent perceives in this replay. */
        var now: MessagePerception? = null
            private set

        fun receive(message: PerceivedSnapshot, ms: Long) {
            before = (message.kept ?: message.texts).flatMap(::read).mapTo(HashSet(), ::literalText)
            now = session.perceive(message.texts, ms)
        }

        fun takeDue(ms: Long): Boolean = session.due(ms)?.also { now = it } != null

        private fun read(text: String): List<Literal> {
            if (whyLeftOut(text.trim()) != null) return emptyList()
            val literal = PerceptReader.read(text.trim())
            return listOf(if (namespace == null) literal else literal.cloneNS(Atom(namespace)) as Literal)
        }
    }
}
