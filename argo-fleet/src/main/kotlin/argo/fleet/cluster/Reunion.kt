package argo.fleet.cluster

import org.jgroups.Address
import org.jgroups.EmptyMessage
import org.jgroups.Message
import org.jgroups.conf.ClassConfigurator
import org.jgroups.protocols.MERGE3
import org.jgroups.stack.IpAddress
import org.jgroups.util.Util
import java.net.InetSocketAddress
import java.util.concurrent.TimeUnit

/**
 * Lets separated parts of a fleet detect within a few intervals that they are connected again. In each interval, the oldest member of a
 * part sends its view to all hosts. The other members of the part send theirs to the oldest. A member also answers a different view with
 * its own. In JGroups' own protocol, each member asks each host.
 *
 * @param hosts the addresses of the other hosts
 */
internal class Reunion(hosts: Collection<InetSocketAddress>) : MERGE3() {
    private val hosts = hosts.map { IpAddress(it.address, it.port) }

    init {
        setId<MERGE3>(ClassConfigurator.getProtocolId(MERGE3::class.java))
    }

    @Synchronized
    override fun startInfoSender() {
        if (isInfoSenderRunning) return
        val first = Util.random(max_interval)
        info_sender_future = timer.scheduleWithFixedDelay(::tell, first, max_interval, TimeUnit.MILLISECONDS, false)
    }

    private fun tell() {
        val seen = view ?: return
        val strangers = synchronized(views) { views.filterValues { it != seen.viewId }.keys.toSet() }
        val others: Collection<Address> = if (is_coord) hosts else listOf(seen.coord)
        (others + strangers).forEach {
            down_prot.down(EmptyMessage(it).putHeader(id, createInfo()).setFlag(Message.TransientFlag.DONT_BLOCK))
        }
    }
}
