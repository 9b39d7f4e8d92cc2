package argo.recording.replay

import argo.recording.Cycle
import argo.recording.PerceptChange
import argo.recording.agent.literalOf
import jason.asSyntax.Literal

internal interface ReplayedPercepts {
    /** Begins with [percepts], which the agent perceived before its first replayed cycle. */
    fun begin(percepts: List<Literal>)

    /** Returns the agent's percepts in [cycle], which is recorded or additional; null if nothing has changed. */
    fun perceive(cycle: Cycle): List<Literal>?

    /** Returns the new percepts of the last perception that meet critical rules. */
    fun takeNewlyCritical(): List<Literal>
}

internal class RecordedPercepts : ReplayedPercepts {
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

    /** Returns the literal of a percept. Reads each text only once, like the recorded agent. Jason copies literals that it believes. */
    private fun perceptOf(text: String): Literal {
        if (known.size >= MAX_KNOWN) known.clear()
        return known.getOrPut(text) { literalOf(text) }
    }

    override fun takeNewlyCritical(): List<Literal> = critical.map(::literalOf)

    private companion object {
        const val MAX_KNOWN = 4096
    }
}

/** Perceives the recorded percepts. From the cycle with the index [from] on, [changed] changes the agent's percepts. */
internal class AlteredPercepts(
    private val from: Long,
    private val changed: (List<Literal>) -> List<Literal>,
    private val recorded: ReplayedPercepts = RecordedPercepts(),
) : ReplayedPercepts by recorded {
    override fun perceive(cycle: Cycle): List<Literal>? = recorded.perceive(cycle)?.let { if (cycle.index < from) it else changed(it) }
}

/** Returns [percepts] as they are after this change. [read] makes a literal of a text. */
internal fun PerceptChange.appliedTo(percepts: List<Literal>, read: (String) -> Literal = ::literalOf): List<Literal> =
    percepts.take(keep) + now.map(read) + percepts.takeLast(keepLast)
