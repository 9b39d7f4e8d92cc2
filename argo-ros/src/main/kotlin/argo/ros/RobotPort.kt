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

internal class RobotPort private constructor(val mapping: String, val connect: (BridgeListener, LineClock) -> Bridge) {
    companion object {
        private const val ENDINGS = "mcap|db3|bag|zstd"
        private val BAG = Regex("replay:(.+\\.(?:$ENDINGS)|[^#]+)(?:#.*)?")
        private val ENDED = Regex(".*\\.(?:$ENDINGS)")

        /** Returns true if [port] names a bag file. The bag may be unreadable. */
        fun isBag(port: String) = fileIn(port) != null

        private fun fileIn(port: String) = BAG.matchEntire(port)?.groupValues?.get(1)
            ?.takeIf { ENDED.matches(it) || pathOf(it)?.let(Files::isDirectory) == true }

        /** @throws NoSuchPortException if [port] names neither a robot nor a bag */
        fun of(port: String): RobotPort {
            val file = fileIn(port) ?: return robot(port, RosAddress.of(port))
            val mapping = port.removePrefix("replay:$file").removePrefix("#")
            return RobotPort(mapping.ifEmpty { RosAddress.USUAL_MAPPING }) { listener, clock ->
                PlayedBridge(listener, clock, bagIn(port, file), ForkJoinPool.commonPool()) { _, _ -> }
            }
        }

        private fun robot(port: String, address: RosAddress) = RobotPort(address.mapping) { listener, _ ->
            BridgeSocket.connect(port, address.socket, listener, findCredentials(address.mapping))
        }

        /** @throws javino.PortException if [file] cannot be read as a bag */
        fun bagIn(port: String, file: String): Bag {
            val path = pathOf(file) ?: throw NoSuchPortException(port, "there is no bag $file in ${Path.of("").toAbsolutePath()}")
            if (Files.isDirectory(path)) throw NoSuchPortException(port, "$file is a folder; the bag is the file in it that ends in .mcap")
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
