package argo.ros.joining

import argo.ros.RosAddress
import argo.ros.mapping.Credentials
import argo.ros.mapping.MappingException
import argo.ros.mapping.findCredentials
import javino.NoSuchPortException

internal class BridgeAddress(val ros: RosAddress, val credentials: Credentials) {
    companion object {
        private val NUMBER = Regex("[0-9]+")

        /**
         * Reads `HOST:PORT` or `ros://HOST:PORT#NAME`. Reads the token from the file `NAME.ros.token`, as for the port of an agent.
         *
         * @throws NoSuchPortException if [text] is no such address, or the token cannot be read
         */
        fun of(text: String): BridgeAddress {
            if (NUMBER.matches(text)) throw NoSuchPortException(
                text,
                "$text is only a number, at which earlier versions listened for ROS clients. Boards join the graph of a running " +
                    "rosbridge_server: write its address, as \"localhost:$text\". Without ROS the live view shows them, argo_view=$text",
            )
            val address = RosAddress.of(if (text.startsWith("ros:") || text.startsWith("wss:")) text else "ros://$text")
            return try {
                BridgeAddress(address, findCredentials(address.mapping))
            } catch (refused: MappingException) {
                throw NoSuchPortException(text, refused.message.orEmpty())
            }
        }
    }
}
