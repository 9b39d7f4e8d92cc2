package argo.fleet.agents

import argo.insides.Insides
import argo.mind.Mind
import argo.mind.beginAnew
import argo.mind.replaceMind
import argo.platform.Plans
import argo.recording.agent.MessageContent
import jason.asSemantics.Agent
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.Plan
import jason.asSyntax.Pred
import jason.asSyntax.UnnamedVar
import jason.asSyntax.VarTerm
import java.util.logging.Logger

/**
 * Reads [text], which another computer has written by [MessageContent.write], for [agent]. Jason numbers variables and the labels of plans
 * within one program, so those of the other computer get numbers of this one.
 *
 * @throws IllegalArgumentException if [text] cannot be read
 */
internal fun readForeign(text: String, agent: Agent): Any = MessageContent.read(text, agent).also { content ->
    if (content is Literal && !content.isGround) content.makeVarsAnnon(OwnVariables())
    relabel(content, agent)
}

/**
 * Gives the agent of [ts] the mind [program]. The mind replaces the beliefs and goals of the agent's own program. Call this function
 * between reading that program and starting the agent.
 *
 * @throws IllegalArgumentException if [program] cannot be read. The agent is then unchanged
 */
internal fun restore(ts: TransitionSystem, program: String, log: Logger) {
    val mind = Mind.ofProgram(program)
    val beliefs = mind.beliefs.map { readForeign(it, ts.ag) as Literal }
    val events = mind.events.map { it to readForeign(it.drop(1), ts.ag) as Literal }
    replaceMind(ts, beliefs, log::warning)
    events.forEach { (event, literal) -> beginAnew(ts, event, literal) }
}

/**
 * Names each variable anew. Jason's own unifier takes the variable with the greater number for the newer one; of numbers that two computers
 * have counted it would make two variables of one.
 */
private class OwnVariables : Unifier() {
    private val own = HashMap<VarTerm, VarTerm>()

    override fun deref(variable: VarTerm): VarTerm = own.getOrPut(variable) { generateSequence { UnnamedVar() }.first { it != variable } }
}

/** Gives a plan another label if [agent] has another plan with the label that Jason has given to this one. */
private fun relabel(content: Any, agent: Agent) {
    if (content is ListTerm) content.forEach { relabel(it, agent) }
    val label = (content as? Plan)?.label?.takeIf { GIVEN.matches(it.functor) } ?: return
    val plans = Plans.of(agent).copy()
    if (plans.none { it.label?.functor == label.functor && it != content }) return
    val labels = plans.mapNotNull { it.label?.functor }.toSet()
    val free = generateSequence { "p__${Insides.planCounter[null].incrementAndGet()}" }.first { it !in labels }
    content.label = Pred(free).apply { setAnnots(label.annots) }
}

/** A label that Jason gives to a plan without one. */
private val GIVEN = Regex("[lp]__[0-9]+")
