package argo.fleet.cluster

import org.jgroups.util.DefaultSocketFactory
import java.io.IOException
import java.net.ServerSocket
import java.net.Socket
import java.net.SocketException
import java.util.concurrent.Executors
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.SynchronousQueue
import java.util.concurrent.ThreadFactory
import java.util.concurrent.ThreadPoolExecutor
import java.util.concurrent.TimeUnit

/** Makes the sockets of JGroups' TCP. */
internal class FleetSockets(private val entrance: Entrance) : DefaultSocketFactory() {
    private val refusals = Refusals()

    override fun createSocket(service: String): Socket = FleetSocket(entrance, refusals)
    override fun createServerSocket(service: String): ServerSocket = Door(entrance, refusals)
}

/**
 * Accepts connections, and passes those of the fleet to JGroups. A few threads exchange greetings. The door closes a connection if the
 * greeting takes too long, or if all greeting threads are busy. Connections from outside the fleet therefore need no more memory than these
 * threads, whatever they send.
 */
internal class Door(private val entrance: Entrance, private val refusals: Refusals) : ServerSocket() {
    private val greeted = LinkedBlockingQueue<Socket>()
    private val forStrangers = porters(PORTERS)

    /** The threads serve only the fleet's own addresses. Connections from outside the fleet cannot keep them busy. */
    private val forHosts = porters(1 + 2 * entrance.computers)
    private val watch: ScheduledExecutorService = Executors.newSingleThreadScheduledExecutor(daemons("fleet-door-watch"))
    private val opening = lazy { daemons("fleet-door").newThread(::admitAll).start() }

    /** Returns the next connection from a computer of the fleet. */
    override fun accept(): Socket {
        opening.value
        val next = greeted.take()
        if (!isClosed) return next
        next.close()
        throw SocketException("closed")
    }

    private fun admitAll() {
        while (!isClosed) {
            val socket = FleetSocket(entrance, refusals)
            try {
                implAccept(socket)
                (if (socket.inetAddress in entrance.addresses) forHosts else forStrangers).execute { admit(socket) }
            } catch (e: IOException) {
                if (!isClosed) refusals.tell("a connection could not be accepted: ${e.message}")
                if (!isClosed) Thread.sleep(PAUSE_MILLIS)
            } catch (@Suppress("SwallowedException") e: RejectedExecutionException) {
                refusals.tell("connections of strangers come faster than they can be refused; some are closed unheard")
                socket.close()
            }
        }
    }

    private fun admit(socket: FleetSocket) {
        val end = try {
            watch.schedule(socket::close, PATIENCE_MILLIS, TimeUnit.MILLISECONDS)
        } catch (@Suppress("SwallowedException") e: RejectedExecutionException) {
            return socket.close() // the door is closed
        }
        try {
            socket.answer()
            if (end.cancel(false)) greeted.add(socket)
        } catch (@Suppress("SwallowedException") e: IOException) {
            end.cancel(false) // the log has the reason
        }
    }

    override fun close() {
        super.close()
        forStrangers.shutdownNow()
        forHosts.shutdownNow()
        watch.shutdownNow()
        generateSequence(greeted::poll).forEach(Socket::close)
        greeted.add(Socket()) // ends the wait in accept
    }

    private companion object {
        const val PORTERS = 8
        const val PATIENCE_MILLIS = 3000L

        /** The pause after a failed accept. The operating system may have no free file descriptors. */
        const val PAUSE_MILLIS = 100L

        fun porters(most: Int) = ThreadPoolExecutor(0, most, 1, TimeUnit.SECONDS, SynchronousQueue(), daemons("fleet-porter"))

        fun daemons(name: String) = ThreadFactory { Thread(it, name).apply { isDaemon = true } }
    }
}
