package argo.recording.replay

import argo.recording.Cycle
import argo.recording.PerceptChange
import argo.recording.agent.literalOf
import jason.asSyntax.Literal

/** What an agent perceives that is run on a recording. */
internal interface Senses {
    /** It has perceived these [percepts], recorded so, before its first cycle. */
    fun begin(percepts: List<Literal>)

    /** What it perceives in [cycle], recorded or one of its own; null: nothing has changed. */
    fun perceive(cycle: Cycle): List<Literal>?

    /** The percepts of the last perception that meet critical rules and are new. */
    fun takeNewlyCritical(): List<Literal>
}

/** What was recorded. */
internal class RecordedSenses : Senses {
    private var percepts: List<Literal> = emptyList()
    private var critical: List<String> = emptyList()
    private val known = HashMap<String, Literal>()

    override fun begin(percepts: List<Literal>) {
        this.percepts = percepts
    }

    override fun perceive(cycle: Cycle): List<Literal>? {
        critical = cycle.input.critical
        val change = cycle.input.percepts ?: return null
        percepts = change.appliedTo(percepts, ::perceptOf)
        return percepts
    }

    /** The literal of a percept, read once for each text, as when it was perceived: Jason copies what it believes. */
    private fun perceptOf(text: String): Literal {
        if (known.size >= MAX_KNOWN) known.clear()
        return known.getOrPut(text) { literalOf(text) }
    }

    override fun takeNewlyCritical(): List<Literal> = critical.map(::literalOf)

    private companion object {
        const val MAX_KNOWN = 4096
    }
}

/** What is perceived after the change where [percepts] were before; [read] makes a literal of a percept. */
internal fun PerceptChange.appliedTo(percepts: List<Literal>, read: (String) -> Literal = ::literalOf): List<Literal> =
    percepts.take(keep) + now.map(read) + percepts.takeLast(keepLast)
