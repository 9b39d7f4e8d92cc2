package argo.ros

import javino.NoSuchPortException
import java.net.URI
import java.net.URISyntaxException

/**
 * The address of a bridge, and the name of the mapping file for its robot.
 *
 * Examples: `ros://robot.local:9090`, `ros://robot:9090#left`, `wss://robot.example/rosbridge#left`.
 *
 * [mapping] is the text behind `#`, or `robot` without a `#`.
 */
internal data class RosAddress(val socket: URI, val mapping: String) {
    companion object {
        const val USUAL_MAPPING = "robot"
        private const val USUAL_PORT = 9090
        private const val ENCRYPTED_PORT = 443
        private const val MAX_PORT = 65_535
        private val FORM =
            Regex("(ros|wss):(?://)?(\\[[0-9A-Fa-f:.%]+]|[A-Za-z0-9._-]+)(?::([0-9]{1,5}))?(/[A-Za-z0-9._~%/-]*)?(?:#(.*))?")

        fun of(port: String): RosAddress {
            val (scheme, host, number, path, mapping) = FORM.matchEntire(port)?.destructured ?: throw malformed(port)
            val usualPort = if (scheme == "wss") ENCRYPTED_PORT else USUAL_PORT
            val socketPort = if (number.isEmpty()) usualPort else number.toInt()
            if (socketPort !in 1..MAX_PORT) throw malformed(port)
            val protocol = if (scheme == "wss") scheme else "ws"
            val socket = try {
                URI("$protocol://$host:$socketPort${path.ifEmpty { "/" }}")
            } catch (_: URISyntaxException) {
                throw malformed(port)
            }
            if (socket.host == null) throw NoSuchPortException(port, "\"$host\" is no name of a host that Java takes; use its address")
            return RosAddress(socket, mapping.ifEmpty { USUAL_MAPPING })
        }

        private fun malformed(port: String) = if ('?' in port) NoSuchPortException(
            port, "a token stands in the file robot.ros.token beside robot.ros.yaml, not in the name of a port, which is logged",
        ) else NoSuchPortException(
            port, "\"$port\" names no robot: that is ros://HOST:PORT, as ros://192.168.1.20:9090, with encryption wss://HOST/PATH, " +
                "and #NAME behind it for NAME.ros.yaml",
        )
    }
}
