package argo.fleet.cluster

import java.net.InetAddress
import java.net.InetSocketAddress
import java.nio.file.Path

/**
 * The settings of a computer in a fleet.
 *
 * @property fleet the fleet's name; computers of other fleets are refused
 * @property here this computer's name
 * @property hosts the addresses at which the computers listen, by computer name, with this computer. Addresses may be unresolved. If empty,
 * every computer on the local network belongs to the fleet
 * @property bind the address at which this computer listens. If [hosts] is empty, other computers are searched on this interface, too
 * @property certificates the folder with the certificates, as for `tls://`. Null means unencrypted connections, which everybody who reaches
 * the port can use
 * @property insecure true if the user allows unencrypted connections beyond the loopback interface
 * @throws IllegalArgumentException if the settings contradict each other; the message is for the user
 */
data class ClusterSettings(
    val fleet: String,
    val here: String,
    val hosts: Map<String, InetSocketAddress>,
    val bind: InetSocketAddress,
    val certificates: Path? = null,
    val insecure: Boolean = false,
) {
    init {
        requireName("fleet", fleet)
        (hosts.keys + here).forEach { requireName("computer", it) }
        require(hosts.isEmpty() || here in hosts) { "no computer of the fleet $fleet is called $here; it has ${hosts.keys.joinToString()}" }
        hosts.entries.groupBy({ it.value }, { it.key }).forEach { (address, names) ->
            require(names.size == 1) {
                "the computers ${names.joinToString(" and ")} have the same address, ${address.hostString}:${address.port}"
            }
        }
        require(!bind.isUnresolved) { "the address of ${bind.hostString} is not known" }
        require(certificates == null || hosts.isNotEmpty()) {
            "with certificates the fleet has to name its hosts: what strangers say where computers look for each other cannot be checked"
        }
        require(certificates != null || insecure || bind.address.isLoopbackAddress) {
            "${bind.address.hostAddress} can be reached by others, and without certificates everybody among them may take part in the" +
                " fleet: name the folder of its certificates, tls(\"folder\"), or say insecure"
        }
    }

    companion object {
        /** The port at which a computer listens by default. */
        const val DEFAULT_PORT = 4711

        /** The greatest length of a computer's or a fleet's name, in ASCII characters. */
        const val MAX_NAME = 64
        private val NAME = Regex("[A-Za-z0-9_.-]{1,$MAX_NAME}")

        private fun requireName(what: String, name: String) = require(NAME.matches(name)) {
            "\"$name\" is no name of a $what: that has 1 to $MAX_NAME letters, digits, dots, hyphens and underscores"
        }

        /** The address of the loopback interface, to which no other computer can connect. */
        fun loopback(port: Int): InetSocketAddress = InetSocketAddress(InetAddress.getLoopbackAddress(), port)
    }
}
