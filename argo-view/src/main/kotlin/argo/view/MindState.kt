package argo.view

import argo.observing.ObservedAgent
import argo.observing.isHidden
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

        /** Returns the mind of [agent]. For the agent's thread only. */
        fun of(agent: ObservedAgent): MindState {
            val believed = of(agent.beliefs)
            val circumstance = agent.circumstance
            val intentions = circumstance.allIntentions.asSequence().take(MAX_LOOKED_AT).filterNot { it.isFinished }.distinctBy { it.id }
                .sortedBy { it.id }.toList()
            val shown = intentions.take(MAX_INTENTIONS).map { intentionState(it, circumstance.getPendingIntentionKey(it)) }
            return MindState(believed.believed, believed.beliefs, intentions.size, shown)
        }

        /** Returns a mind with the beliefs in [base] and no intentions. */
        fun of(base: BeliefBase): MindState {
            val perceived = base.percepts.asSequence().take(MAX_OF_A_KIND)
            val (hidden, others) = base.asSequence().take(MAX_LOOKED_AT).filterNot { it.hasSource(BeliefBase.APercept) }
                .partition { it.isHidden }
            return MindState(base.size() - hidden.size, (others.take(MAX_OF_A_KIND) + perceived).map(::belief))
        }

        private fun belief(literal: Literal): Belief {
            val sources = literal.sources.map { "$it" }
            val bare = literal.copy().apply { delSources() }
            return Belief(shown("$bare"), sources)
        }
    }
}
