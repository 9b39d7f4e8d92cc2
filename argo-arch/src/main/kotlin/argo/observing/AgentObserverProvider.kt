package argo.observing

import java.util.logging.Logger

/**
 * Opens observers of agents that have its option, such as `agents: robot [argo_view=8080] agentArchClass argo.Arch;`.
 *
 * [java.util.ServiceLoader] finds it: a class with a public constructor without arguments, named in
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
     * @return null: the observer cannot be opened; [log] has the reason, and the agent runs without it
     */
    fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver?
}
