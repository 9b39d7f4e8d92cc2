package argo.ros

import argo.links.BoardLink
import argo.links.BoardLinkProvider
import argo.links.PlayedBoard
import argo.ros.bridge.Bag
import argo.ros.bridge.Bridge
import argo.ros.bridge.BridgeListener
import argo.ros.bridge.BridgeSocket
import argo.ros.bridge.PlayedBridge
import argo.ros.bridge.operationIn
import argo.ros.mapping.CommandRule
import argo.ros.mapping.MappingException
import argo.ros.mapping.findCredentials
import argo.ros.mapping.findMapping
import javino.LineClock
import javino.PortFaultException
import java.nio.file.Path
import java.util.concurrent.ForkJoinPool

/** Opens `ros://host:9090`: a ROS robot behind a bridge of the rosbridge protocol, version 2. */
open class RosLinkProvider : BoardLinkProvider {
    override val scheme: String get() = "ros"

    /** Takes the address that a bridge prints, `ws://…`, as well: [open] refuses it, and says how ARGO writes it. */
    override fun opens(port: String): Boolean = super.opens(port) || port.startsWith("ws:")

    override fun open(port: String, isPaced: Boolean, clock: LineClock): BoardLink {
        val robot = RobotPort.of(port)
        val mapping = read(port) { findMapping(robot.mapping) }
        return RosLink.over(port, mapping, isPaced, clock) { robot.connect(it, clock) }
    }

    override fun play(port: String, isPaced: Boolean, clock: LineClock, recording: Path?, heard: (String, String) -> Unit): PlayedBoard {
        lateinit var bridge: PlayedBridge
        val mapping = read(port) { findMapping(RobotPort.of(port).mapping) }
        val bag = recording?.let { Bag.open(port, "$it") }
        val answering = mapping.commands.filter { it.kind != CommandRule.Kind.TOPIC }.map { it.target }.toSet()
        val link = RosLink.over(port, mapping, isPaced, clock) { listener ->
            PlayedBridge(listener, clock, bag, heard = heard).also { bridge = it }
        }
        return object : PlayedBoard(link) {
            override fun says(name: String, message: String) {
                val json = requireNotNull(operationIn(message)) { "a message is a JSON object, not $message" }
                if (name in answering) bridge.respond(name, json) else bridge.publish(name, json)
            }

            override fun goes() = bridge.end()
        }
    }

    private fun <T> read(port: String, find: () -> T): T = try {
        find()
    } catch (refused: MappingException) {
        throw PortFaultException(port, "port $port cannot be opened: ${refused.message}", refused)
    }
}

/** Opens `wss://host/path`: a ROS robot behind a bridge, over an encrypted connection. */
class EncryptedRosLinkProvider : RosLinkProvider() {
    override val scheme: String get() = "wss"
}

/** Opens `replay:bag.mcap`: plays a ROS 2 bag in place of a robot, with the robot's mapping. */
class BagLinkProvider : RosLinkProvider() {
    override val scheme: String get() = "replay"

    override fun opens(port: String): Boolean = Bag.fileIn(port) != null
}

/** The robot or the bag that a port names. [mapping] is the name of its mapping. */
internal class RobotPort private constructor(val mapping: String, val connect: (BridgeListener, LineClock) -> Bridge) {
    companion object {
        /** @throws javino.NoSuchPortException if [port] names neither a robot nor a bag */
        fun of(port: String): RobotPort {
            val file = Bag.fileIn(port) ?: return robot(port, RosAddress.of(port))
            val mapping = port.removePrefix("replay:$file").removePrefix("#")
            return RobotPort(mapping.ifEmpty { RosAddress.USUAL_MAPPING }) { listener, clock ->
                PlayedBridge(listener, clock, Bag.open(port, file), ForkJoinPool.commonPool()) { _, _ -> }
            }
        }

        private fun robot(port: String, address: RosAddress) = RobotPort(address.mapping) { listener, _ ->
            BridgeSocket.connect(port, address.socket, listener, findCredentials(address.mapping))
        }
    }
}
