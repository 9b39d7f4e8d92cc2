package argo.ros.serving

import java.util.concurrent.ConcurrentHashMap
import java.util.logging.Logger

/**
 * The servers of this program, one for each address that agents ask for: agents that ask for the same one share it, on purpose, so that all
 * agents of a system are on one graph. Safe for use by several threads.
 */
internal object RosServers {
    private class Shared(val graph: Graph, val server: RosServer)

    private val log = Logger.getLogger(RosServer::class.java.name)
    private val servers = HashMap<String, Shared>()

    /**
     * Makes a participant by [participant] and adds it to the graph of the server at [address], as [Access.of] reads it.
     *
     * @return the port that it listens at
     * @throws RefusedServer if there can be none
     */
    @Synchronized
    fun <P : Participant> join(address: String, participant: (Graph) -> P): Pair<P, Int> {
        val shared = servers[address] ?: open(address).also { servers[address] = it }
        return participant(shared.graph).also(shared.graph::add) to shared.server.port
    }

    private fun open(address: String): Shared {
        val graph = Graph(onceEach(log::warning))
        return Shared(graph, RosServer(Access.of(address), graph, log::info))
    }

    /** Takes [participant] off the server at [address]; the last one ends it. Does not wait. */
    @Synchronized
    fun leave(address: String, participant: Participant) {
        val shared = servers[address] ?: return
        shared.graph.remove(participant)
        if (!shared.graph.isEmpty) return
        servers -= address
        Thread({ shared.server.close() }, "argo-ros-closing").apply { isDaemon = true }.start()
    }
}

/** Wraps [tell] so that it gets each text once, and some hundred texts at most. */
internal fun onceEach(tell: (String) -> Unit): (String) -> Unit {
    val told = ConcurrentHashMap.newKeySet<String>()
    return { if (told.size < MAX_TOLD && told.add(it)) tell(it) }
}

private const val MAX_TOLD = 200
