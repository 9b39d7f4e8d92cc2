package argo.ros.serving

import argo.observing.AgentObserver
import argo.observing.AgentObserverProvider
import argo.observing.ObservedAgent
import java.util.logging.Logger

/** Offers agents that have the option `argo_ros` by the rosbridge protocol. */
class AgentRosProvider : AgentObserverProvider {
    override val option = "argo_ros"
    override val usage = "a port number, or \"HOST:PORT?token=TOKEN\""

    override fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver? {
        val address = value.trim().removeSurrounding("\"")
        return try {
            val (observer, port) = RosServers.join(address) { graph -> AgentRos(agent, graph.topics) { RosServers.leave(address, it) } }
            observer.also { log.info("ROS clients find ${agent.name} as /${it.name} at port $port") }
        } catch (refused: RefusedServer) {
            null.also { log.severe("$option: ${refused.message}; the agent runs without it") }
        }
    }
}
