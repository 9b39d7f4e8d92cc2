package argo.orders

import argo.observing.Order
import argo.observing.Outcome
import argo.platform.Plans
import jason.asSemantics.Circumstance
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.BinaryStructure
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import jason.asSyntax.parser.ParseException
import jason.asSyntax.parser.TokenMgrError
import jason.asSyntax.parser.as2j
import jason.asSyntax.parser.as2jConstants
import jason.bb.BeliefBase
import jason.stdlib.drop_desire
import java.io.StringReader

private const val IN_PLACE = "-+"
private const val PERCEPTS_ARE_SENSED = "a percept is believed as long as the agent perceives it"

/** Carries out an [Order.Believe] with the belief in [text]. */
internal fun TransitionSystem.believe(text: String): Outcome {
    val takesPlace = text.trim().startsWith(IN_PLACE)
    val belief = literal(text.trim().removePrefix(IN_PLACE).removePrefix("+"), "belief").capply(Unifier()) as Literal // computes sums
    if (belief.functor == "true" || belief.functor == "false") refuse("$belief is a word of AgentSpeak, which cannot be a belief's name")
    if (!belief.isGround) refuse("the belief $belief has a variable without a value")
    if (belief.hasSource(BeliefBase.APercept)) refuse("$PERCEPTS_ARE_SENSED; believe $text with another source, or with none")
    if (takesPlace) forgetOthers(belief)
    return if (ag.addBel(belief)) Outcome(null) else Outcome(null, listOf("the agent believed $belief already"))
}

/** Removes one belief that differs from [belief] only in its arguments, as Jason's `-+belief` does first. */
private fun TransitionSystem.forgetOthers(belief: Literal) {
    val any = belief.copy().apply { makeTermsAnnon() }
    ag.delBel(any)
}

/** Carries out an [Order.Forget] with the pattern in [text]. */
internal fun TransitionSystem.forget(text: String): Outcome {
    val pattern = literal(text.trim().removePrefix("-"), "belief")
    val found = ag.bb.getCandidateBeliefs(pattern, Unifier())?.asSequence().orEmpty()
        .filter { !it.isRule && Unifier().unifies(pattern, it) }.toList()
    val lost = found.map { belief -> belief.copy().also { if (!pattern.hasSource()) it.delSource(BeliefBase.APercept) } }
        .filter { it.hasSource() && !pattern.hasSource(BeliefBase.APercept) }
    if (found.isEmpty()) refuse("the agent does not believe $pattern")
    if (lost.isEmpty()) refuse("$PERCEPTS_ARE_SENSED: it cannot forget $pattern")
    lost.forEach { ag.delBel(if (pattern.hasSource()) it.onlyOf(pattern) else it) }
    return Outcome(null, if (lost.size > 1) listOf("the agent has forgotten ${lost.size} beliefs") else emptyList())
}

/** Removes all sources of this belief that [pattern] does not name. */
private fun Literal.onlyOf(pattern: Literal) = apply { sources.filterNot(pattern::hasSource).forEach(::delSource) }

/** Carries out an [Order.Begin] with the goal in [text]. */
internal fun TransitionSystem.begin(text: String): Outcome {
    val goal = goal(text)
    if (!hasPlan(goal)) refuse("the agent has no plan for +!${goal.functor}/${goal.arity}")
    goal.makeVarsAnnon()
    if (!goal.hasSource()) goal.addAnnot(BeliefBase.TSelf)
    c.addAchvGoal(goal, Intention.EmptyInt)
    return Outcome(null)
}

/** Returns true if a plan of the agent may be relevant to [goal]. */
internal fun TransitionSystem.hasPlan(goal: Literal): Boolean =
    Plans.of(ag).hasCandidate(Trigger(Trigger.TEOperator.add, Trigger.TEType.achieve, goal))

/** Carries out an [Order.Drop] with the goal in [text]. */
internal fun TransitionSystem.drop(text: String): Outcome {
    val goal = goal(text)
    val before = c.sizes()
    drop_desire().execute(this, Unifier(), arrayOf<Term>(goal))
    if (c.sizes() == before) refuse("the agent has no intention and no event for !$goal")
    return Outcome(null)
}

private fun Circumstance.sizes() = listOf(
    runningIntentionsPlusAtomic.asSequence().count(), pendingIntentions.size, pendingActions.size,
    eventsPlusAtomic.asSequence().count(), pendingEvents.size,
)

private fun TransitionSystem.goal(text: String): Literal = literal(text.trim().removePrefix("+").removePrefix("!"), "goal")

/** Reads [text] as a literal. Error messages call the literal a [what]. */
private fun TransitionSystem.literal(text: String, what: String): Literal {
    val literal = try {
        parsed(text)
    } catch (wrong: Exception) { // ParseException; RuntimeException for expressions that are no formulas, and for large numbers
        refuseText(text, what, wrong)
    } catch (wrong: TokenMgrError) {
        refuseText(text, what, wrong)
    } catch (_: StackOverflowError) {
        refuse("the $what is nested too deep to be read")
    }
    val isPlain = !literal.isVar && literal !is InternalActionLiteral && literal !is BinaryStructure && !literal.isList
    if (!isPlain) refuse("a $what is a literal such as near(wall), not $text")
    return literal.forceFullLiteralImpl()
}

/** Lets Jason read [text] as a literal of the agent. The literal may contain the agent's own functions. */
private fun TransitionSystem.parsed(text: String): Literal {
    val parser = as2j(StringReader(text))
    parser.setAg(ag)
    return parser.literal().also {
        val rest = parser.nextToken
        if (rest.kind != as2jConstants.EOF) throw ParseException("\"${rest.image}\" behind $it does not belong there")
    }
}

private fun refuseText(text: String, what: String, cause: Throwable): Nothing =
    refuse("'$text' is no $what that Jason can read: ${cause.message.orEmpty().lineSequence().first()}")

private fun refuse(why: String): Nothing = throw OrderRefusedException(why)
