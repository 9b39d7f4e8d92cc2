package argo.fleet.cluster

import org.jgroups.protocols.Discovery
import org.jgroups.protocols.FD_ALL3
import org.jgroups.protocols.MERGE3
import org.jgroups.protocols.MPING
import org.jgroups.protocols.PerDestinationBundler
import org.jgroups.protocols.TCP
import org.jgroups.protocols.TCPPING
import org.jgroups.protocols.UNICAST3
import org.jgroups.protocols.VERIFY_SUSPECT2
import org.jgroups.protocols.pbcast.GMS
import org.jgroups.protocols.pbcast.NAKACK2
import org.jgroups.protocols.pbcast.STABLE
import org.jgroups.stack.DiagnosticsHandler
import org.jgroups.stack.Protocol
import org.jgroups.util.LazyThreadFactory
import java.net.InetAddress
import java.net.InetSocketAddress

/** JGroups' protocols, from the network upwards: who is there, and bytes to them. Times are in milliseconds, sizes in bytes. */
internal fun stackOf(settings: ClusterSettings, sockets: FleetSockets): List<Protocol> = listOf(
    transport(settings.bind, sockets),
    discovery(settings),
    merging(settings.hosts.size),
    failures(),
    // asks a suspect before it is given up: a connection may break while both ends live
    VERIFY_SUSPECT2().apply { setTimeout(VERIFYING) },
    // views go to all through these three; messages of ours do not: see GroupCluster
    NAKACK2().apply { useMcastXmit(false) },
    UNICAST3(),
    STABLE(),
    GMS().apply {
        setJoinTimeout(JOINING)
        // the view is installed here before others acknowledge it; the next change must not wait for one that has gone meanwhile
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
    // nothing waits for more to send, or for an acknowledgement of TCP's
    tcpNodelay(true)
    // a host that is off answers nothing; one thread for each waits this long
    setSockConnTimeout(CONNECTING)
    // a process that ends closes its connections: it is suspected at once
    enableSuspectEvents(true)
    setMaxLength(MAX_BYTES)
    // two buffers for each connection; messages are small
    setBufferedInputStreamSize(BUFFER)
    setBufferedOutputStreamSize(BUFFER)
    // at least twice what we have under way to one computer: no write waits for one that does not read (Outgoing)
    setSendBufSize(SEND_BUFFER)
    // a queue and a thread for each computer: one that is off delays no other, and whoever sends never waits
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
        // a host whose name nobody knows now finds this computer by itself when it comes
        setInitialHosts<TCPPING>(settings.hosts.values.filter { !it.isUnresolved })
        setPortRange<TCPPING>(0)
    }
    return found.apply { asyncDiscovery<Discovery>(true) }
}

/**
 * Parts of a fleet that can reach each other again find that out within 1.6 times the longer interval. Each computer asks each host at
 * the pace of the intervals, so they grow with the fleet.
 */
private fun merging(hosts: Int) = MERGE3().apply {
    val longest = maxOf(MERGING, MERGING_FOR_EACH * hosts)
    setMaxInterval(longest)
    setMinInterval(longest / 2)
}

/** A sign of life each second or so to each computer; whoever gave none in two rounds is suspected, after three rounds at most. */
private fun failures() = FD_ALL3().apply {
    setInterval(SIGN_OF_LIFE)
    setTimeout(2 * SIGN_OF_LIFE)
}

private const val SIGN_OF_LIFE = 800L
private const val VERIFYING = 200L
private const val JOINING = 1000L
private const val VIEW_ACKNOWLEDGEMENTS = 500L
private const val CONNECTING = 500
private const val MERGING = 1500L
private const val MERGING_FOR_EACH = 200L
private const val MAX_BYTES = 1 shl 20
private const val BUFFER = 32 shl 10
private const val BUNDLE = 24 shl 10
private const val QUEUE = 1024
private const val SEND_BUFFER = 200 shl 10
