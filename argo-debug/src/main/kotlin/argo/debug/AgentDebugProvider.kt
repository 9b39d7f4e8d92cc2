package argo.debug

import argo.observing.AgentObserver
import argo.observing.AgentObserverProvider
import argo.observing.ObservedAgent
import java.io.IOException
import java.util.logging.Logger

/** Lets debuggers connect to agents that have the option `argo_debug`. */
class AgentDebugProvider : AgentObserverProvider {
    override val option = "argo_debug"
    override val usage = "a port number"

    override fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver? {
        fun refuse(reason: String) = null.also { log.severe("$option=$value: $reason; no debugger can reach the agent") }
        val port = value.trim().toIntOrNull()?.takeIf { it in 0..MAX_PORT }
            ?: return refuse("debuggers reach an agent at the number of a port from 0 to $MAX_PORT, 0 being any that is free")
        return try {
            val server = DebugServers.join(port, agent)
            log.info("debuggers reach ${agent.name} at port ${server.port} of this computer")
            object : AgentObserver {
                override fun close() = DebugServers.leave(server, agent)
            }
        } catch (trouble: IOException) {
            refuse("port $port cannot be had, it is in use or not allowed (${trouble.message}); choose another")
        }
    }

    private companion object {
        const val MAX_PORT = 65535
    }
}
