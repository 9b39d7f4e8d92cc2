package argo.observing

import java.util.logging.Logger

/**
 * Opens observers for agents with the provider's [option], such as `agents: robot [argo_view=8080] agentArchClass argo.Arch;`.
 *
 * [java.util.ServiceLoader] finds the provider: its class has a public constructor without arguments, and is named in
 * `META-INF/services/argo.observing.AgentObserverProvider`.
 */
interface AgentObserverProvider {
    /** The option of the `.mas2j` that asks for an observer. The name begins with `argo_`. */
    val option: String

    /** The value of the option, in a few words for a person, such as `a port number`. */
    val usage: String

    /**
     * Opens the observer of [agent]. Called by the thread that creates the agent, before its first reasoning cycle.
     *
     * @param value the value of the option
     * @param log the agent's log
     * @return the observer; null: it cannot be opened. Then [log] has the reason, and the agent runs without the observer
     */
    fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver?
}
