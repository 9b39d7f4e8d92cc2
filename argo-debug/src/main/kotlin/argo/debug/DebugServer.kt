package argo.debug

import argo.observing.ObservedAgent
import org.eclipse.lsp4j.debug.launch.DSPLauncher
import java.io.BufferedInputStream
import java.io.IOException
import java.io.InputStream
import java.net.InetAddress
import java.net.ServerSocket
import java.net.Socket
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.atomic.AtomicBoolean
import java.util.concurrent.atomic.AtomicInteger
import java.util.logging.Logger
import kotlin.concurrent.thread

/**
 * Lets debuggers on this computer connect to agents, by the Debug Adapter Protocol over TCP. Safe for use by several threads.
 *
 * @param wanted the port; 0 for any free port
 */
internal class DebugServer(wanted: Int) : AutoCloseable {
    private val socket = ServerSocket(wanted, BACKLOG, InetAddress.getLoopbackAddress())
    private val agents = CopyOnWriteArrayList<AgentThread>()
    private val sessions = CopyOnWriteArrayList<DebugSession>()
    private val numbers = AtomicInteger()
    private val hasToldOfStranger = AtomicBoolean()

    val port: Int get() = socket.localPort

    val isEmpty: Boolean get() = agents.isEmpty()

    init {
        start("argo-debug-$port", ::accept)
    }

    fun add(agent: ObservedAgent) {
        val added = AgentThread(numbers.incrementAndGet(), agent)
        agents += added
        sessions.forEach { it.joined(added) }
    }

    fun remove(agent: ObservedAgent) {
        val gone = agents.find { it.agent === agent } ?: return
        agents -= gone
        sessions.forEach { it.left(gone) }
    }

    private fun accept() {
        while (true) {
            val client = try {
                socket.accept()
            } catch (_: IOException) {
                return // the server is closed
            }
            start("argo-debug-$port-client") { client.use(::serve) }
        }
    }

    private fun serve(client: Socket) {
        val input = BufferedInputStream(client.getInputStream())
        if (!isDebugger(input)) {
            if (!hasToldOfStranger.getAndSet(true)) LOG.warning("port $port is for debuggers, and something else is refused there")
            return
        }
        val session = DebugSession(agents)
        sessions += session
        try {
            val launcher = DSPLauncher.createServerLauncher(session, input, client.getOutputStream())
            session.begin(launcher.remoteProxy, client::shutdownInput)
            launcher.startListening().get()
        } catch (trouble: java.util.concurrent.ExecutionException) {
            LOG.fine { "a debugger has gone: ${trouble.cause}" }
        } finally {
            sessions -= session
            session.end()
        }
    }

    /** Returns true if [input] begins like the protocol. A browser, for example, begins with a method of HTTP instead. */
    private fun isDebugger(input: InputStream): Boolean = try {
        val begin = "Content-Length:"
        input.mark(begin.length)
        val found = String(input.readNBytes(begin.length), Charsets.US_ASCII)
        input.reset()
        found.equals(begin, ignoreCase = true)
    } catch (_: IOException) {
        true // the client has closed the connection
    }

    override fun close() {
        socket.close()
        sessions.forEach(DebugSession::hangUp)
    }

    private fun start(name: String, run: () -> Unit) = thread(name = name, isDaemon = true, block = run)

    private companion object {
        const val BACKLOG = 5
        val LOG: Logger = Logger.getLogger(DebugServer::class.java.name)
    }
}
