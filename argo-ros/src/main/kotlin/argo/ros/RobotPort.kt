package argo.ros

import argo.ros.bridge.Bag
import argo.ros.bridge.Bridge
import argo.ros.bridge.BridgeListener
import argo.ros.bridge.BridgeSocket
import argo.ros.bridge.PlayedBridge
import argo.ros.mapping.findCredentials
import javino.LineClock
import javino.NoSuchPortException
import javino.PortFaultException
import java.io.IOException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path
import java.util.concurrent.ForkJoinPool

/** A robot, or a bag that replaces it, by the name of a port. [mapping] is the name of its mapping. */
internal class RobotPort private constructor(val mapping: String, val connect: (BridgeListener, LineClock) -> Bridge) {
    companion object {
        private val BAG = Regex("replay:(.+\\.mcap)(?:#(.*))?")

        fun isBag(port: String) = BAG.matches(port)

        /** @throws NoSuchPortException if [port] names neither a robot nor a bag */
        fun of(port: String): RobotPort {
            val (file, mapping) = BAG.matchEntire(port)?.destructured ?: return robot(port, RosAddress.of(port))
            return RobotPort(mapping.ifEmpty { RosAddress.USUAL_MAPPING }) { listener, clock ->
                PlayedBridge(listener, clock, bagIn(port, file), ForkJoinPool.commonPool()) { _, _ -> }
            }
        }

        private fun robot(port: String, address: RosAddress) = RobotPort(address.mapping) { listener, _ ->
            BridgeSocket.connect(port, address.socket, listener, findCredentials(address.mapping))
        }

        /** @throws javino.PortException if [file] is no bag that can be read */
        fun bagIn(port: String, file: String): Bag {
            val path = pathOf(file) ?: throw NoSuchPortException(port, "there is no bag $file in ${Path.of("").toAbsolutePath()}")
            return try {
                Bag(path)
            } catch (unreadable: IOException) {
                throw PortFaultException(port, "port $port cannot be opened: ${unreadable.message}", unreadable)
            }
        }

        private fun pathOf(file: String): Path? = try {
            Path.of(file).takeIf(Files::exists)
        } catch (_: InvalidPathException) {
            null
        }
    }
}
