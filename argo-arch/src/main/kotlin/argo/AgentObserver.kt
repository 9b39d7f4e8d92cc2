package argo

import argo.calls.Failure
import argo.filters.PerceptionFilter
import argo.perception.Snapshot
import argo.ports.PortStatus
import jason.asSyntax.Term

/**
 * Is told what happens to an agent, by the thread that it happens on. Each call returns at once and throws nothing.
 */
internal interface AgentObserver {
    /** A message of the board has gone through the filter, or what the filter had held back of the last one was due. */
    fun filtered(snapshot: Snapshot)

    /** The agent perceives [snapshot]. */
    fun handedOver(snapshot: Snapshot)

    /** The agent wants [text] sent to the board on [port]. The result is to be called with how that ended. */
    fun commandIssued(port: String, text: String): (Failure?) -> Unit

    /** [port] has come into this state. */
    fun portChanged(port: Term, status: PortStatus, reason: String?)

    /** The agent perceives through [filter] from now on. */
    fun filterChanged(filter: PerceptionFilter?)

    /** A reasoning cycle is over; called by the agent's thread. */
    fun cycleFinished()
}

/** Nobody looks. */
internal object Unobserved : AgentObserver {
    private val ignore: (Failure?) -> Unit = {}

    override fun filtered(snapshot: Snapshot) = Unit
    override fun handedOver(snapshot: Snapshot) = Unit
    override fun commandIssued(port: String, text: String) = ignore
    override fun portChanged(port: Term, status: PortStatus, reason: String?) = Unit
    override fun filterChanged(filter: PerceptionFilter?) = Unit
    override fun cycleFinished() = Unit
}
