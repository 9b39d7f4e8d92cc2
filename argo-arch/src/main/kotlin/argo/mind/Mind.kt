package argo.mind

import argo.observing.isHidden
import jason.JasonException
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal
import jason.asSyntax.Rule
import jason.asSyntax.Trigger
import jason.asSyntax.Trigger.TEOperator
import jason.asSyntax.Trigger.TEType
import jason.bb.BeliefBase

/**
 * The beliefs of an agent and the events of its intentions, as texts in AgentSpeak. Percepts are left out, since they come from the world.
 * Rules and plans are left out, since they come from the program.
 *
 * @property events the events that have begun the agent's intentions, and the events that wait: `!goal` or `+belief`. Events of percepts
 * are left out, since the percepts will cause them again
 */
data class Mind(val beliefs: List<String>, val events: List<String>) {
    /** The mind as a program, with a belief or an event on each line: `watches(a,b)[source(self)].`, `!oversee.` */
    fun program(): String = (beliefs + events).joinToString("\n") { "$it." }

    companion object {
        /**
         * Returns the mind of the agent of [ts]. Called by the agent's thread.
         *
         * @param write returns the text of a literal; throws [IllegalArgumentException] with the reason if the literal has no text
         * @param leftOut receives each belief or event that has no text of one line, with the reason
         */
        fun of(ts: TransitionSystem, write: (Literal) -> String, leftOut: (String) -> Unit): Mind {
            fun text(literal: Literal): String? = try {
                write(literal).also { require(it.none(LINE_BREAKS::contains)) { "a name in it has a line break" } }
            } catch (refused: IllegalArgumentException) {
                leftOut("$literal: ${refused.message}")
                null
            }
            return Mind(
                beliefs(ts).mapNotNull(::text),
                triggers(ts).mapNotNull { begun -> text(begun.literal)?.let { if (begun.isAchvGoal) "!$it" else "+$it" } },
            )
        }

        /** Reads [program], a text from [Mind.program]. */
        fun ofProgram(program: String): Mind = of(program.lines().filter { it.isNotBlank() }.map { it.trim().removeSuffix(".") })

        /** Returns the mind with the beliefs and events in [facts]. */
        fun of(facts: List<String>): Mind = facts.partition { it.first() !in "!+" }.let { (beliefs, events) -> Mind(beliefs, events) }

        private fun beliefs(ts: TransitionSystem): List<Literal> = ts.ag.bb.filterNot(::isOfProgram).mapNotNull(::withoutPercept)

        /** Returns [belief] without the source `percept`; null if it has no other source. */
        private fun withoutPercept(belief: Literal): Literal? =
            if (!belief.hasSource(BeliefBase.APercept)) belief
            else belief.copy().also { it.delSource(BeliefBase.APercept) }.takeIf { it.hasSource() }

        /** Returns the triggers that have begun the agent's intentions, with the values of their variables, then the waiting triggers. */
        private fun triggers(ts: TransitionSystem): List<Trigger> {
            val begun = ts.c.allIntentions.asSequence().mapNotNull { intention ->
                intention.lastOrNull()?.let { Trigger(it.trigger.operator, it.trigger.type, it.trigger.literal.capply(it.unif) as Literal) }
            }
            val waiting = (ts.c.events + listOfNotNull(ts.c.atomicEvent))
                .filter { it.intention == null || it.intention === Intention.EmptyInt }.map { it.trigger }
            return (begun.toList() + waiting).filter { it.isAddition && (it.isAchvGoal || isOfMind(it)) }
        }

        private fun isOfMind(trigger: Trigger) =
            trigger.type == TEType.belief && !isOfProgram(trigger.literal) && withoutPercept(trigger.literal) != null
    }
}

/** Returns true if [belief] belongs to the program. No [Mind] contains it, and [replaceMind] keeps it. */
private fun isOfProgram(belief: Literal) = belief is Rule || belief.isHidden

/**
 * Replaces the beliefs of the agent of [ts] by [beliefs], before its first cycle. The program's rules and hidden beliefs stay. The
 * program's initial beliefs and goals are removed. Beliefs cause no events, since the agent had them in its last run. Called by the agent's
 * thread.
 *
 * @param refused receives each belief that the agent's belief base refuses, with the reason
 */
fun replaceMind(ts: TransitionSystem, beliefs: List<Literal>, refused: (String) -> Unit) {
    val bb = ts.ag.bb
    val own = bb.filter(::isOfProgram)
    bb.clear()
    ts.c.clearEvents()
    for (belief in own + beliefs) {
        try {
            bb.add(AT_END, belief)
        } catch (refusal: JasonException) {
            refused("$belief is not believed any more: ${refusal.message}")
        }
    }
}

/** Puts [event], an event of a [Mind] with this [literal], into the queue of the agent of [ts]. Called by the agent's thread. */
fun beginAnew(ts: TransitionSystem, event: String, literal: Literal) {
    if (event.startsWith("!")) ts.c.addAchvGoal(literal, Intention.EmptyInt)
    else ts.c.addEvent(Event(Trigger(TEOperator.add, TEType.belief, literal), Intention.EmptyInt))
}

/** Jason allows line breaks in a quoted atom, but [Mind.program] has one line for each belief and each event. */
private const val LINE_BREAKS = "\n\r"

/** To keep the order of beliefs: with this index, Jason puts a belief after all other beliefs with its functor. */
private const val AT_END = 1
