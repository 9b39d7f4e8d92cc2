package argo.fleet.agents

import jason.asSemantics.Agent
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Term
import jason.stdlib.broadcast
import jason.stdlib.kill_agent
import jason.stdlib.send

/** Jason's internal actions that send messages. In a fleet these wait until the message has arrived on the other computer, or fail. */
internal object FleetActions {
    /** Has the program of [agent] use them. Jason looks an action up for each agent, by the name of its class. */
    fun install(agent: Agent) {
        agent.setIA(send::class.java.name, FleetSend())
        agent.setIA(broadcast::class.java.name, FleetBroadcast())
        agent.setIA(kill_agent::class.java.name, FleetKill())
    }
}

/** `.send`: waits until the computer of the receiver has taken the message. */
internal class FleetSend : send() {
    private val wait = DeliveryWait()

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        wait.carryOut(ts, { super.suspendIntention() }) { super.execute(ts, un, args) }

    override fun suspendIntention() = super.suspendIntention() || wait.isWaiting
}

/** `.broadcast`: waits until the computers of all receivers have taken the message. */
internal class FleetBroadcast : broadcast() {
    private val wait = DeliveryWait()

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        wait.carryOut(ts, { false }) { super.execute(ts, un, args) }

    override fun suspendIntention() = wait.isWaiting
}

/** `.kill_agent`: waits until the computer of the agent has answered. */
internal class FleetKill : kill_agent() {
    private val wait = DeliveryWait()

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        wait.carryOut(ts, { false }) { super.execute(ts, un, args) }

    override fun suspendIntention() = wait.isWaiting
}
