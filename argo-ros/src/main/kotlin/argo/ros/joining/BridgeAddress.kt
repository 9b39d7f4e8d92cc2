package argo.ros.joining

import argo.ros.RosAddress
import argo.ros.mapping.Credentials
import argo.ros.mapping.MappingException
import argo.ros.mapping.findCredentials
import javino.NoSuchPortException

/** A text is no address of a bridge; [message] tells why. */
internal class RefusedAddress(message: String) : Exception(message)

/** The address of the bridge to a graph, and the credentials for this bridge. */
internal class BridgeAddress(val ros: RosAddress, val credentials: Credentials) {
    companion object {
        private val NUMBER = Regex("[0-9]+")

        /**
         * Reads `HOST:PORT`, also in the form of an agent's port, `ros://HOST:PORT#NAME`. Reads the token from the file `NAME.ros.token`,
         * as for an agent's port.
         *
         * @throws RefusedAddress if [text] is no such address, or the token cannot be read
         */
        fun of(text: String): BridgeAddress {
            if (NUMBER.matches(text)) throw RefusedAddress(
                "$text is only a number, at which earlier versions listened for ROS clients. Boards join the graph of a running " +
                    "rosbridge_server: write its address, as \"localhost:$text\". Without ROS the live view shows them, argo_view=$text",
            )
            return try {
                val address = RosAddress.of(if (text.startsWith("ros:") || text.startsWith("wss:")) text else "ros://$text")
                BridgeAddress(address, findCredentials(address.mapping))
            } catch (refused: NoSuchPortException) {
                throw RefusedAddress(refused.message.orEmpty())
            } catch (refused: MappingException) {
                throw RefusedAddress(refused.message.orEmpty())
            }
        }
    }
}
