package argo.view

import argo.observing.ObservedAgent
import argo.observing.isHidden
import jason.asSemantics.Circumstance
import jason.asSyntax.Literal
import jason.bb.BeliefBase

/**
 * The beliefs and intentions of an agent at one moment.
 *
 * @property believed the number of all beliefs, without those that Jason hides
 * @property intended the number of all intentions
 */
internal class MindState(
    val believed: Int,
    val beliefs: List<Belief>,
    val intended: Int = 0,
    val intentions: List<IntentionState> = emptyList(),
) {
    companion object {
        private const val MAX_OF_A_KIND = 150
        private const val MAX_LOOKED_AT = 5000
        private const val MAX_INTENTIONS = 30
        private const val MAX_FORGETTABLE = 300

        /** Returns the mind of [agent]. For the agent's thread only. */
        fun of(agent: ObservedAgent): MindState = of(agent.beliefs, agent.circumstance)

        fun of(base: BeliefBase, circumstance: Circumstance): MindState {
            val perceived = base.percepts.asSequence().take(MAX_OF_A_KIND)
            val (hidden, others) = base.asSequence().take(MAX_LOOKED_AT).filterNot { it.hasSource(BeliefBase.APercept) }
                .partition { it.isHidden }
            val all = circumstance.allIntentions
            val intentions = all.asSequence().take(MAX_LOOKED_AT).filterNot { it.isFinished }.distinctBy { it.id }
                .sortedBy { it.id }.toList()
            val notLookedAt = all.asSequence().count()
            return MindState(
                base.size() - hidden.size,
                (others.take(MAX_OF_A_KIND) + perceived).map(::belief),
                intentions.size + notLookedAt,
                intentions.take(MAX_INTENTIONS).map { intentionState(it, circumstance.getPendingIntentionKey(it)) },
            )
        }

        private fun belief(literal: Literal): Belief {
            val sources = literal.sources.map { "$it" }
            val bare = literal.copy().apply { delSources() }
            val whole = "$literal".takeUnless { literal.isRule || literal.hasSource(BeliefBase.APercept) || it.length > MAX_FORGETTABLE }
            return Belief(shown("$bare"), sources, whole)
        }
    }
}
