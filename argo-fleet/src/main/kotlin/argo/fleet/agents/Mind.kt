package argo.fleet.agents

import argo.recording.agent.MessageContent
import jason.JasonException
import jason.asSemantics.Agent
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Rule
import jason.bb.BeliefBase
import java.util.logging.Logger

private val HIDDEN = ASSyntax.createAtom("hide_in_mind_inspector")

/** Returns true if [belief] comes from the program. Beliefs of the program are in no mind, and stay when a mind is restored. */
private fun isOfProgram(belief: Literal) = belief is Rule || belief.hasAnnot(HIDDEN)

/**
 * The beliefs and goals of an agent, each as a literal in AgentSpeak, without percepts, rules and plans. The goals are those with which
 * intentions began. Intentions that did not begin with a goal are left out.
 */
internal data class Mind(val beliefs: List<String>, val goals: List<String>) {
    /** The mind as a program: `watches(a,b)[source(self)]. … !oversee.` */
    fun program(): String = (beliefs.map { "$it." } + goals.map { "!$it." }).joinToString("\n")

    companion object {
        /** Returns the mind of the agent of [ts]. Called by its thread. [leftOut] gets what no text can hold, each with the reason. */
        fun of(ts: TransitionSystem, leftOut: (String) -> Unit): Mind {
            fun text(literal: Literal): String? = try {
                MessageContent.write(literal)
            } catch (refused: IllegalArgumentException) {
                leftOut("$literal: ${refused.message}")
                null
            }
            return Mind(kept(ts.ag).mapNotNull(::text), goals(ts).mapNotNull(::text))
        }

        private fun kept(agent: Agent): List<Literal> =
            agent.bb.filterNot { isOfProgram(it) || it.annots?.any { source -> source == BeliefBase.TPercept } == true }

        private fun goals(ts: TransitionSystem): List<Literal> {
            val waiting = ts.c.events.filter { it.intention == null || it.intention === Intention.EmptyInt }
                .map { it.trigger }.filter { it.isAddition && it.isAchvGoal }.map { it.literal }
            return ts.c.allIntentions.asSequence().mapNotNull(::goal).toList() + waiting
        }

        /** Returns the goal with which [intention] began, with the values of its variables; null: [intention] did not begin with a goal. */
        private fun goal(intention: Intention): Literal? =
            intention.filter { it.trigger.isAddition && it.trigger.isAchvGoal }.lastOrNull()?.let { begun ->
                begun.trigger.literal.capply(begun.unif) as Literal
            }
    }
}

/**
 * Gives the agent of [ts], which has read its program and has not begun, the mind in [program] instead of its own beginning.
 *
 * @throws IllegalArgumentException if [program] cannot be read
 */
internal fun restore(ts: TransitionSystem, program: String, log: Logger) {
    val lines = program.lines().filter { it.isNotEmpty() }.map { it.removeSuffix(".") }
    val bb = ts.ag.bb
    val own = bb.filter(::isOfProgram)
    bb.clear()
    own.forEach(bb::add)
    ts.c.clearEvents()
    for (line in lines) {
        val literal = MessageContent.read(line.removePrefix("!"), ts.ag) as Literal
        try {
            if (line.startsWith("!")) ts.c.addAchvGoal(literal, Intention.EmptyInt) else bb.add(literal)
        } catch (refused: JasonException) {
            log.warning("$line is not believed any more: ${refused.message}")
        }
    }
}
