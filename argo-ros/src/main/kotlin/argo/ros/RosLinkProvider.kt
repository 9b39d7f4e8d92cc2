package argo.ros

import argo.links.BoardLink
import argo.links.BoardLinkProvider
import argo.ros.mapping.MappingException
import argo.ros.mapping.findMapping
import javino.LineClock
import javino.PortFaultException

/** Opens `ros://host:9090`: a robot that speaks ROS, behind a bridge of the rosbridge protocol, version 2. */
class RosLinkProvider : BoardLinkProvider {
    override val scheme: String get() = "ros"

    override fun open(port: String, isPaced: Boolean, clock: LineClock): BoardLink {
        val address = RosAddress.of(port)
        val mapping = try {
            findMapping(address.mapping)
        } catch (refused: MappingException) {
            throw PortFaultException(port, "port $port cannot be opened: ${refused.message}", refused)
        }
        return RosLink.open(port, address.socket, mapping, isPaced, clock)
    }
}
