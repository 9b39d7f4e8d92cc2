package argo.fleet.cluster

import org.jgroups.Address
import org.jgroups.BytesMessage
import org.jgroups.Global
import org.jgroups.JChannel
import org.jgroups.Message
import org.jgroups.Receiver
import org.jgroups.View
import org.jgroups.logging.LogFactory
import org.jgroups.util.ExtendedUUID
import java.io.IOException
import java.net.ServerSocket
import java.util.logging.Level
import java.util.logging.Logger

/** Connects a fleet's computers through JGroups. */
object JGroupsCluster {
    /**
     * @return a cluster that has not joined. The cluster's `listen` throws an IOException if this computer cannot listen at
     * [ClusterSettings.bind]
     * @throws IOException if certificates are missing or cannot be read; the message is for the user
     */
    fun open(settings: ClusterSettings): Cluster =
        GroupCluster(JGroupsGroup(settings), settings.hosts.keys, ThreadLoop("fleet-${settings.here}"))
}

/** A group on a channel of JGroups. A member's address on that channel is a random number that includes the computer's name. */
internal class JGroupsGroup(private val settings: ClusterSettings) : Group, Receiver {
    private val address = ExtendedUUID.randomUUID().put(NAME, settings.here.toByteArray())
    val channel: JChannel
    private lateinit var listener: GroupListener
    private val refusals = Refusals()

    /** The members of the last view, by address. [addresses] is the inverse. */
    @Volatile
    private var members = mapOf<Address, Computer>()

    @Volatile
    private var addresses = mapOf<Computer, Address>()

    override val here = memberOf(address)

    init {
        quieten()
        settings.hosts.filterValues { it.isUnresolved }.keys.forEach {
            LOG.log(System.Logger.Level.WARNING, "the address of the computer $it is not known; it is in touch once it has found this one")
        }
        val certificates = settings.certificates?.let(::FleetCertificates)
        val sockets = FleetSockets(Entrance(Greeting.of(settings), certificates, settings.hosts))
        channel = JChannel(stackOf(settings, sockets))
        channel.addAddressGenerator { address }
        channel.setName(settings.here)
        channel.receiver = this
    }

    override fun join(listener: GroupListener) {
        this.listener = listener
        try {
            channel.connect(settings.fleet)
        } catch (@Suppress("TooGenericExceptionCaught") e: Exception) {
            channel.close()
            val reason = runCatching { ServerSocket().use { it.bind(settings.bind) } }.exceptionOrNull()?.message // `e` has no reason
                ?: generateSequence<Throwable>(e) { it.cause }.last().message
            throw IOException("this computer cannot listen at ${settings.bind.hostString}:${settings.bind.port}: $reason", e)
        }
    }

    override fun viewAccepted(view: View) {
        members = view.members.associateWith(::memberOf)
        addresses = members.entries.associate { it.value to it.key }
        listener.viewed(members.values.toList())
    }

    override fun receive(message: Message) {
        val from = members[message.src] ?: return // no member in this view yet; the sender will repeat the message
        val origin = Origin.current
        if (from.name != origin) return refusals.tell("$origin sends messages under the name of ${from.name}, which are left out")
        if (message is BytesMessage) listener.arrived(from, message.array.copyOfRange(message.offset, message.offset + message.length))
    }

    override fun transmit(to: Computer, frame: ByteArray) {
        val destination = addresses[to] ?: return
        try {
            channel.send(BytesMessage(destination, frame).setFlag(Message.Flag.NO_RELIABILITY))
        } catch (e: IllegalStateException) {
            LOG.log(System.Logger.Level.DEBUG, "the channel is closed", e)
        }
    }

    override fun close() = channel.close()

    private fun memberOf(address: Address): Computer {
        val name = (address as? ExtendedUUID)?.get(NAME)?.let { String(it) }
        return Computer(name ?: "?", (address as? org.jgroups.util.UUID)?.toStringLong() ?: address.toString())
    }

    private companion object {
        const val NAME = "n"
        val LOG: System.Logger = System.getLogger(Cluster::class.java.name)

        /** The loggers of JGroups, and of its protocols that have a class in this package. Kept, since else their levels are lost. */
        val JGROUPS: List<Logger> = listOf(Connections::class, Reunion::class, SignsOfLife::class, Verification::class)
            .map { it.java.name }.plus("org.jgroups").map(Logger::getLogger)

        /**
         * Turns off JGroups' log. JGroups warns of each ended connection with class names, and this package logs everything that users
         * need. Forbids JGroups to read Java objects. Computers of the fleet send none. JGroups reads the property for that once.
         */
        fun quieten() {
            LogFactory.useJdkLogger(true)
            JGROUPS.filter { it.level == null }.forEach { it.level = Level.OFF }
            System.setProperty(Global.DESERIALIZATION_FILTER, System.getProperty(Global.DESERIALIZATION_FILTER) ?: "!*")
        }
    }
}
