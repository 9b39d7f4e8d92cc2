package benchmarks.ros

import org.java_websocket.WebSocket
import org.java_websocket.handshake.ClientHandshake
import org.java_websocket.server.WebSocketServer
import java.net.InetAddress
import java.net.InetSocketAddress
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.CountDownLatch
import java.util.concurrent.ScheduledThreadPoolExecutor
import java.util.concurrent.TimeUnit

/**
 * The topics and messages of a robot that counts.
 *
 * @property topic the topic with the numbers
 * @property message makes the message for a number
 * @property answers the topic of the commands
 * @property number finds the number in a command behind this text
 */
internal class Counted(val topic: String, val answers: String, number: String, val message: (Int) -> String) {
    val number = Regex("$number: ?(\\d+)")

    companion object {
        val NUMBERS = Counted("/n", "/did", "\"data\"") { """{"data":$it}""" }
    }
}

/**
 * A bridge that publishes increasing numbers. The bridge sends only the newest message in each `throttle_rate`, like rosbridge 0.11.17 with
 * `queue_length` 1.
 *
 * @param number the TCP port of the bridge, or 0 for a free one
 * @param hz the published numbers per second
 * @param published called with each number before its publication
 */
internal class CountingBridge(
    number: Int,
    first: Int,
    hz: Int,
    private val counted: Counted = Counted.NUMBERS,
    private val published: (Int) -> Unit,
) : AutoCloseable {
    private val started = CountDownLatch(1)
    private val timer = ScheduledThreadPoolExecutor(1) { Thread(it, "counting-bridge").apply { isDaemon = true } }
    private var next = first
    private var waiting: Int? = null

    @Volatile
    private var throttleNanos: Long? = null // the shortest time between messages, or null without a subscriber
    private var sentNanos = System.nanoTime()

    /** Called with the number in each command, on a thread of the bridge. */
    @Volatile
    var heard: (Int) -> Unit = { }

    /** True if the bridge publishes the next numbers by itself. */
    @Volatile
    var isCounting = true

    val done = ConcurrentLinkedQueue<Int>()

    private val server = object : WebSocketServer(InetSocketAddress(InetAddress.getLoopbackAddress(), number), 1) {
        override fun onOpen(client: WebSocket, handshake: ClientHandshake) = Unit

        override fun onClose(client: WebSocket, code: Int, reason: String, remote: Boolean) {
            if (connections.isEmpty()) throttleNanos = null
        }

        override fun onMessage(client: WebSocket, message: String) = hear(client, message)

        override fun onError(client: WebSocket?, trouble: Exception) {
            if (client == null) System.err.println("the bridge fails: $trouble")
        }

        override fun onStart() = started.countDown()
    }.apply {
        isReuseAddr = true
        isDaemon = true
        isTcpNoDelay = true
        start()
    }

    init {
        check(started.await(START_S, TimeUnit.SECONDS)) { "the bridge does not start" }
        timer.scheduleAtFixedRate(::count, 0, TimeUnit.SECONDS.toNanos(1) / hz, TimeUnit.NANOSECONDS)
    }

    val number: Int get() = server.port

    val clients: Int get() = server.connections.size

    private fun hear(client: WebSocket, message: String) {
        val id = ID.find(message)?.groupValues?.get(1)
        when {
            "\"subscribe\"" in message && "\"${counted.topic}\"" in message ->
                throttleNanos = TimeUnit.MILLISECONDS.toNanos(THROTTLE.find(message)?.groupValues?.get(1)?.toLong() ?: 0)
            "\"unsubscribe\"" in message -> throttleNanos = null
            "\"${counted.answers}\"" in message && "\"publish\"" in message -> counted.number.find(message)?.let { answered(it) }
            "\"call_service\"" in message -> client.send("""{"op":"service_response","id":"$id","values":"there is none","result":false}""")
        }
    }

    private fun answered(number: MatchResult) = number.groupValues[1].toInt().let {
        heard(it)
        done += it
    }

    private fun count() {
        if (!isCounting) return
        published(next)
        waiting = next++
        val interval = throttleNanos ?: return
        val now = System.nanoTime()
        val number = waiting?.takeIf { now - sentNanos >= interval } ?: return
        waiting = null
        sentNanos = now
        val text = """{"op":"publish","topic":"${counted.topic}","msg":${counted.message(number)}}"""
        server.connections.forEach { if (it.isOpen) it.send(text) }
    }

    override fun close() {
        timer.shutdownNow()
        timer.awaitTermination(START_S, TimeUnit.SECONDS)
        server.stop(0)
    }

    private companion object {
        const val START_S = 20L
        val ID = Regex("\"id\": ?\"([^\"]*)\"")
        val THROTTLE = Regex("\"throttle_rate\": ?(\\d+)")
    }
}
