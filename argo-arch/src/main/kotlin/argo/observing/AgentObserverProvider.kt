package argo.observing

import java.util.logging.Logger

/**
 * Opens observers for agents with the provider's [option], such as `agents: robot [argo_view=8080] agentArchClass argo.Arch;`.
 *
 * [java.util.ServiceLoader] finds the provider. The provider's class has a public constructor without arguments, and is named in
 * `META-INF/services/argo.observing.AgentObserverProvider`.
 */
interface AgentObserverProvider {
    /** The option of the `.mas2j` that asks for an observer. The name begins with `argo_`. */
    val option: String

    /** The kind of value that the option takes, in a few words for a person, such as `a port number`. */
    val usage: String

    /**
     * Opens the observer of [agent]. Called by the thread that creates the agent, before its first reasoning cycle.
     *
     * @param value the value of the option
     * @param log the agent's log
     * @return the observer; null if it cannot be opened. In this case write the reason to [log]; the agent runs without the observer
     */
    fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver?
}
