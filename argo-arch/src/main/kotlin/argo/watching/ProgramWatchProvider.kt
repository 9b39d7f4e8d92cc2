package argo.watching

import argo.observing.AgentObserver
import argo.observing.AgentObserverProvider
import argo.observing.ObservedAgent
import java.util.logging.Logger

/** Reloads agents with the option `argo_watch=true` when their files are saved. */
class ProgramWatchProvider : AgentObserverProvider {
    override val option = "argo_watch"
    override val usage = "true or false"

    override fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver? = when (value.trim()) {
        "true" -> ProgramWatch(agent, log)
        "false" -> null
        else -> null.also { log.severe("$option=$value: it is $usage; the agent's files are not watched") }
    }
}
