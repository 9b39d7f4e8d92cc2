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
import java.net.InetAddress
import java.net.InetSocketAddress

/** Returns JGroups' protocols, from the network upwards. Times are in milliseconds, sizes in bytes. */
internal fun stackOf(settings: ClusterSettings, sockets: FleetSockets): List<Protocol> = listOf(
    transport(settings.bind, sockets),
    discovery(settings),
    merging(settings),
    failures(settings.hosts.size),
    // a suspected computer is asked before it is given up, since a connection may break while both ends live
    Verification().setTimeout(VERIFYING),
    // these three carry the views to all computers, but not this project's messages: see GroupCluster
    NAKACK2().apply { useMcastXmit(false) },
    UNICAST3(),
    STABLE(),
    GMS().apply {
        setJoinTimeout(JOINING)
        // this computer installs a view before others acknowledge it, so that a change never waits for a computer that has gone
        setViewAckCollectionTimeout(VIEW_ACKNOWLEDGEMENTS)
        printLocalAddress(false)
        printPhysicalAddress(false)
    },
)

private fun transport(bind: InetSocketAddress, sockets: FleetSockets) = TCP().apply {
    setBindAddr<TCP>(bind.address)
    setBindPort<TCP>(bind.port)
    setPortRange<TCP>(0)
    setSocketFactory(sockets)
    setThreadFactory<TCP>(LazyThreadFactory("fleet", true, true))
    useVirtualThreads<TCP>(false)
    // TCP sends at once, and waits neither for more bytes nor for an acknowledgement
    tcpNodelay(true)
    // for each host that is off, one thread waits this long
    setSockConnTimeout(CONNECTING)
    // a process that ends closes its connections, and so is suspected at once
    enableSuspectEvents(true)
    setMaxLength(MAX_BYTES)
    // two buffers for each connection; messages are small
    setBufferedInputStreamSize(BUFFER)
    setBufferedOutputStreamSize(BUFFER)
    // twice the bytes under way to one computer, or more: so no write waits for a computer that does not read (Outgoing)
    setSendBufSize(SEND_BUFFER)
    // a queue and a thread for each computer: a computer that is off delays no other, and senders never wait
    setBundler<TCP>(PerDestinationBundler().apply {
        useSingleSenderThread(false)
        setMaxSize(BUNDLE)
        setCapacity(QUEUE)
    })
    // the thread that reads a connection hands messages over
    setMessageProcessingPolicy<TCP>("direct")
    // no port for probes, which would answer everybody
    setDiagnosticsHandler<TCP>(DiagnosticsHandler(null, sockets, threadFactory).setEnabled(false))
    enableStats(false)
    logAcceptError(false)
    setLogDiscardMessages<TCP>(false)
}

private fun discovery(settings: ClusterSettings): Discovery {
    val found = if (settings.hosts.isEmpty()) MPING().apply { setBindAddr(settings.bind.address) }
    else TCPPING().apply {
        // a host whose name cannot be resolved now finds this computer later
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

/** With more than twenty hosts, signs of life go less often, so that many computers on one machine leave it idle. */
private fun failures(hosts: Int): FD_ALL3 {
    val round = maxOf(SIGN_OF_LIFE, SIGN_OF_LIFE_FOR_EACH * hosts)
    return SignsOfLife().setInterval(round).setTimeout(2 * round)
}

private const val SIGN_OF_LIFE = 800L
private const val SIGN_OF_LIFE_FOR_EACH = 40L
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
