package argo.view

import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The servers of this program, one for each port. Agents that ask for one port share a server, so a person finds all agents of a system at
 * one address. Agents that ask for any free port (0) also share a server. Safe for use by several threads.
 */
internal object ViewServers {
    private val lock = ReentrantLock()
    private val servers = HashMap<Int, ViewServer>()

    /** Puts [page] on the server for [port]. Throws [java.io.IOException] if the port cannot be opened. */
    fun join(port: Int, page: AgentPage): ViewServer = lock.withLock {
        servers.getOrPut(port) { ViewServer("$port", port) }.also { it.site.add(page) }
    }

    /** Removes [page] from [server], which [page] has joined for [port]. The server ends with its last page. */
    fun leave(port: Int, server: ViewServer, page: AgentPage) {
        val isLast = lock.withLock {
            server.site.remove(page)
            server.site.isEmpty.also { if (it && servers.remove(port, server)) server.closePort() }
        }
        if (isLast) server.endThreads()
    }
}
