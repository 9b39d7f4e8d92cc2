package argo.fleet.agents

import argo.recording.agent.OfInfrastructure
import jason.asSemantics.Agent
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Term
import jason.stdlib.broadcast
import jason.stdlib.kill_agent
import jason.stdlib.send

/** Jason's internal actions that send messages. In a fleet, they wait until the other computer has the message, or they fail. */
internal object FleetActions {
    /**
     * Makes the program of [agent] use the actions of this file. [questions] are those of the agent. Jason stores each agent's actions
     * under the names of Jason's own classes.
     */
    fun install(agent: Agent, questions: Questions) {
        agent.setIA(send::class.java.name, FleetSend(questions))
        agent.setIA(broadcast::class.java.name, FleetBroadcast(questions))
        agent.setIA(kill_agent::class.java.name, FleetKill(questions))
    }
}

/** `.send`: waits until the computer of the receiver has taken the message. */
internal class FleetSend(questions: Questions) : send(), OfInfrastructure {
    private val wait = DeliveryWait(questions)

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = wait.carryOut(ts) { super.execute(ts, un, args) }

    override fun suspendIntention() = super.suspendIntention() || wait.isWaiting
}

/** `.broadcast`: waits until the computers of all receivers have taken the message. */
internal class FleetBroadcast(questions: Questions) : broadcast(), OfInfrastructure {
    private val wait = DeliveryWait(questions)

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = wait.carryOut(ts) { super.execute(ts, un, args) }

    override fun suspendIntention() = wait.isWaiting
}

/** `.kill_agent`: waits until the computer of the agent has answered. */
internal class FleetKill(questions: Questions) : kill_agent(), OfInfrastructure {
    private val wait = DeliveryWait(questions)

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = wait.carryOut(ts) { super.execute(ts, un, args) }

    override fun suspendIntention() = wait.isWaiting
}
