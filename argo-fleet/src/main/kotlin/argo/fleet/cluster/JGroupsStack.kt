package argo.fleet.cluster

import org.jgroups.protocols.Discovery
import org.jgroups.protocols.FD_ALL3
import org.jgroups.protocols.MERGE3
import org.jgroups.protocols.MPING
import org.jgroups.protocols.PerDestinationBundler
import org.jgroups.protocols.TCP
import org.jgroups.protocols.TCPPING
import org.jgroups.protocols.UNICAST3
import org.jgroups.protocols.pbcast.GMS
import org.jgroups.protocols.pbcast.NAKACK2
import org.jgroups.protocols.pbcast.STABLE
import org.jgroups.stack.DiagnosticsHandler
import org.jgroups.stack.Protocol
import org.jgroups.util.LazyThreadFactory
import java.net.InetSocketAddress

/** Returns JGroups' protocols, from the network upwards. Times are in milliseconds, sizes in bytes. */
internal fun stackOf(settings: ClusterSettings, sockets: FleetSockets): List<Protocol> = listOf(
    transport(settings.bind, sockets),
    discovery(settings),
    merging(settings),
    failures(settings.hosts.size),
    // a suspected computer is asked for a sign first, since a connection may break while both ends run
    Verification().setTimeout(VERIFYING),
    // these three protocols send the views to all computers; ARGO's own messages bypass them (GroupCluster)
    NAKACK2().apply {
        useMcastXmit(false)
        setXmitInterval(maxOf(VIEWS_AGAIN, roundOf(settings.hosts.size)))
    },
    UNICAST3().apply { setXmitInterval(maxOf(ANSWERS_AGAIN, roundOf(settings.hosts.size) / 2)) },
    STABLE(),
    GMS().apply {
        setJoinTimeout(JOINING)
        // limits the wait for acknowledgements of a view, so that a new view does not wait for a lost computer
        setViewAckCollectionTimeout(VIEW_ACKNOWLEDGEMENTS)
        printLocalAddress(false)
        printPhysicalAddress(false)
    },
)

private fun transport(bind: InetSocketAddress, sockets: FleetSockets) = Connections().apply {
    setBindAddr<TCP>(bind.address)
    setBindPort<TCP>(bind.port)
    setPortRange<TCP>(0)
    setSocketFactory(sockets)
    setThreadFactory<TCP>(LazyThreadFactory("fleet", true, true))
    useVirtualThreads<TCP>(false)
    // TCP sends bytes at once, without waiting for more bytes or an acknowledgement
    tcpNodelay(true)
    // limits the wait for a connection to a host that is off
    setSockConnTimeout(CONNECTING)
    // a process that ends closes its connections, and is therefore suspected at once
    enableSuspectEvents(true)
    setMaxLength(MAX_BYTES)
    // FleetSocket has its own buffer; another one would hide from Origin that a second thread continues the reading
    setBufferedInputStreamSize(0)
    // the buffer of each connection is small, since messages are small
    setBufferedOutputStreamSize(BUFFER)
    // at least twice the bytes under way to a computer (Outgoing), so that no write waits for a computer that does not read
    setSendBufSize(SEND_BUFFER)
    // a queue and a thread for each computer, so that a lost computer delays no other and no sender waits
    setBundler<TCP>(PerDestinationBundler().apply {
        useSingleSenderThread(false)
        setMaxSize(BUNDLE)
        setCapacity(QUEUE)
    })
    // the reading thread of a connection also delivers its messages
    setMessageProcessingPolicy<TCP>("direct")
    // no port for JGroups' diagnostics, which would answer everybody
    setDiagnosticsHandler<TCP>(DiagnosticsHandler(null, sockets, threadFactory).setEnabled(false))
    enableStats(false)
    logAcceptError(false)
    setLogDiscardMessages<TCP>(false)
}

private fun discovery(settings: ClusterSettings): Discovery {
    val found = if (settings.hosts.isEmpty()) MPING().apply { setBindAddr(settings.bind.address) }
    else TCPPING().apply {
        // leaves out a host whose name cannot be resolved now; that host will find this computer
        setInitialHosts<TCPPING>(settings.hosts.values.filter { !it.isUnresolved })
        setPortRange<TCPPING>(0)
    }
    return found.apply { asyncDiscovery<Discovery>(true) }
}

private fun merging(settings: ClusterSettings): MERGE3 {
    val others = settings.hosts.filter { (name, address) -> name != settings.here && !address.isUnresolved }.values
    val merging = if (settings.hosts.isEmpty()) MERGE3() else Reunion(others)
    return merging.apply {
        setMaxInterval(MERGING)
        setMinInterval(MERGING / 2)
    }
}

private fun failures(hosts: Int): FD_ALL3 = SignsOfLife().setInterval(roundOf(hosts)).setTimeout(2 * roundOf(hosts))

/**
 * Returns the time between two signs of life. With more than twenty hosts, signs of life and checks for lost views are rarer. Many
 * computers can then run on one machine.
 */
private fun roundOf(hosts: Int): Long = maxOf(SIGN_OF_LIFE, SIGN_OF_LIFE_FOR_EACH * hosts)

private const val SIGN_OF_LIFE = 800L
private const val SIGN_OF_LIFE_FOR_EACH = 40L
private const val VIEWS_AGAIN = 1000L
private const val ANSWERS_AGAIN = 500L
private const val VERIFYING = 200L
private const val JOINING = 1000L
private const val VIEW_ACKNOWLEDGEMENTS = 500L
private const val CONNECTING = 500
private const val MERGING = 1500L
private const val MAX_BYTES = 1 shl 20
private const val BUFFER = 32 shl 10
private const val BUNDLE = 24 shl 10
private const val QUEUE = 1024
private const val SEND_BUFFER = 200 shl 10
