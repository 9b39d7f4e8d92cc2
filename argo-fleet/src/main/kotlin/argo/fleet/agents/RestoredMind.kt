package argo.fleet.agents

import argo.mind.Mind
import argo.mind.beginAnew
import argo.mind.replaceMind
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal
import java.util.logging.Logger

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
