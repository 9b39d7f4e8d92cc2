package argo.recording.why

import argo.recording.Cycle
import argo.recording.replay.RecordedSenses
import argo.recording.replay.Senses
import jason.asSyntax.Literal

/** The recorded percepts, passed through [changed] from the cycle with the index [from] on. */
internal class AlteredSenses(private val from: Long, private val changed: (List<Literal>) -> List<Literal>) : Senses {
    private val recorded = RecordedSenses()

    override fun begin(percepts: List<Literal>) = recorded.begin(percepts)

    override fun perceive(cycle: Cycle): List<Literal>? = recorded.perceive(cycle)?.let { if (cycle.index < from) it else changed(it) }

    override fun takeNewlyCritical(): List<Literal> = recorded.takeNewlyCritical()
}
