package argo.fleet.agents

import argo.mind.Mind
import argo.mind.beginAnew
import argo.mind.replaceMind
import argo.recording.agent.MessageContent
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal
import java.util.logging.Logger

/**
 * Gives the agent of [ts], which has read its program and has not begun, [program] as its mind in place of what its program begins with.
 *
 * @throws IllegalArgumentException if it cannot be read; the agent is unchanged
 */
internal fun restore(ts: TransitionSystem, program: String, log: Logger) {
    val mind = Mind.ofProgram(program)
    val beliefs = mind.beliefs.map { MessageContent.read(it, ts.ag) as Literal }
    val events = mind.events.map { it to MessageContent.read(it.drop(1), ts.ag) as Literal }
    replaceMind(ts, beliefs, log::warning)
    events.forEach { (event, literal) -> beginAnew(ts, event, literal) }
}
