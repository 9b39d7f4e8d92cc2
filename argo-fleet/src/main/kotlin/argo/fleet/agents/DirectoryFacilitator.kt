package argo.fleet.agents

import argo.fleet.node.Directory
import argo.fleet.node.Fleet
import argo.fleet.node.Offer
import jason.asSemantics.Message
import jason.asSyntax.ASSyntax
import java.util.concurrent.ConcurrentHashMap

/**
 * Replaces Jason's agent `df` for the whole fleet: agents register services here, and search for services. Each computer knows the services
 * of all computers. A computer informs the subscribers among its own agents.
 *
 * Safe for use by several threads.
 *
 * @param deliver puts a message into the mailbox of a local agent. If the agent has ended, the function does nothing
 */
internal class DirectoryFacilitator(private val fleet: Fleet, private val deliver: (Message) -> Unit) {
    private val subscriptions = ConcurrentHashMap.newKeySet<Offer>() // the agent of these offers is the subscriber

    fun register(agent: String, service: String) = fleet.offer(Offer(agent, service))

    fun deregister(agent: String, service: String) = fleet.withdraw(Offer(agent, service))

    fun search(service: String): Set<String> = fleet.directory.offers.filter { it.service == service }.map { it.agent }.toSet()

    fun subscribe(agent: String, service: String) {
        subscriptions += Offer(agent, service)
        search(service).forEach { tell(agent, it, service) }
    }

    /** All services, by agent. */
    fun services(): Map<String, Set<String>> =
        fleet.directory.offers.groupBy({ it.agent }, { it.service }).mapValues { (_, services) -> services.toSet() }

    fun agentEnded(agent: String) {
        subscriptions.removeIf { it.agent == agent }
    }

    fun directoryChanged(before: Directory, now: Directory) {
        if (subscriptions.isEmpty() || before.offers == now.offers) return
        (now.offers - before.offers).forEach { offer ->
            subscriptions.filter { it.service == offer.service }.forEach { tell(it.agent, offer.agent, offer.service) }
        }
    }

    private fun tell(subscriber: String, provider: String, service: String) {
        val content = ASSyntax.createLiteral("provider", ASSyntax.createAtom(provider), ASSyntax.createString(service))
        deliver(Message("tell", NAME, subscriber, content))
    }

    private companion object {
        /** The sender of the messages to subscribers, as in Jason. */
        const val NAME = "df"
    }
}
