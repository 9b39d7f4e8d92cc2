package argo.debug

import argo.observing.ObservedAgent
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The servers of this program, one for each port. Agents that ask for one port share a server, so a debugger sees all agents of a system.
 * Agents that ask for any free port (0) also share a server. Safe for use by several threads.
 */
internal object DebugServers {
    private val lock = ReentrantLock()
    private val servers = HashMap<Int, DebugServer>()

    /** Adds [agent] to the server for [port], and returns the server. Throws [java.io.IOException] if the port cannot be opened. */
    fun join(port: Int, agent: ObservedAgent): DebugServer = lock.withLock {
        servers.getOrPut(port) { DebugServer(port) }.also { it.add(agent) }
    }

    /** Removes [agent] from [server]. Closes the server if this was its last agent. */
    fun leave(server: DebugServer, agent: ObservedAgent) = lock.withLock {
        server.remove(agent)
        if (server.isEmpty && servers.values.remove(server)) server.close()
    }
}
