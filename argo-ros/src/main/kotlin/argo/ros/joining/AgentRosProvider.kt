package argo.ros.joining

import argo.observing.AgentObserver
import argo.observing.AgentObserverProvider
import argo.observing.ObservedAgent
import argo.ros.bridge.LimitedWarnings
import javino.NoSuchPortException
import java.util.logging.Logger

/** Publishes agents with the option `argo_ros` in a ROS graph. */
class AgentRosProvider : AgentObserverProvider {
    override val option = "argo_ros"
    override val usage = "the address of a bridge, as \"robot:9090\""

    override fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver? = try {
        val bridge = BridgeAddress.of(value.trim().removeSurrounding("\""))
        val warn = LimitedWarnings { log.warning("$option: $it") }
        val topics = Topics(warn)
        lateinit var membership: Membership
        val observer = AgentRos(agent, topics, warn) { membership.close() }
        membership = Membership(observer, topics, bridge, { log.info("$option: $it") }, warn)
        membership.start()
        observer
    } catch (refused: NoSuchPortException) {
        log.severe("$option: ${refused.message}; the agent runs without it")
        null
    }
}
