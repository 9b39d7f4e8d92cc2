package argo.ros.joining

import argo.filters.foreignText
import argo.observing.Farewell
import argo.platform.ThinnedLog
import argo.ros.bridge.Bridge
import argo.ros.bridge.BridgeListener
import argo.ros.bridge.BridgeSocket
import argo.ros.bridge.Outgoing
import argo.ros.bridge.RosApi
import argo.ros.bridge.operation
import argo.ros.bridge.text
import javino.LineClock
import javino.PortException
import kotlinx.serialization.json.JsonObject
import java.util.concurrent.ExecutionException
import java.util.concurrent.Semaphore
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException
import java.util.concurrent.atomic.AtomicInteger

/**
 * Keeps [participant] in the ROS graph behind a bridge. Advertises the participant's services and topics. Repeats this after a restart of
 * the bridge or the graph. Publishes the newest messages of the participant. All work runs on this object's thread, so no caller waits.
 *
 * @param tell takes a line about the connection, for the user
 * @param warn takes reports of things that the graph rejects or lacks, each text once
 */
internal class Membership(
    private val participant: Participant,
    private val topics: Topics,
    private val address: BridgeAddress,
    private val tell: (String) -> Unit,
    private val warn: (String) -> Unit,
) : AutoCloseable {
    private val clock = LineClock.system()
    private val lines = ThinnedLog({ TimeUnit.NANOSECONDS.toMillis(clock.nanos()) }) { delayMs, action ->
        clock.schedule(TimeUnit.MILLISECONDS.toNanos(delayMs), action)
    }
    private val place = "ros://${address.ros.socket.authority}"
    private val news = Semaphore(0)
    private val thread = Thread(::run, "argo-ros-${participant.name}").apply { isDaemon = true }
    private val farewell = Farewell(LEAVING_MS, "the program has ended before ${participant.name} had left $place") {
        close()
        thread.join()
    }
    private var reported = "" // used only by the thread

    @Volatile
    private var isClosed = false

    fun start() {
        topics.onNews = { news.release() }
        thread.start()
    }

    private fun run() {
        while (!isClosed) {
            val restMs = try {
                visit()
            } catch (away: PortException) {
                report("${away.message}; /${participant.name} is advertised as soon as it is there")
                RETRY_MS
            } catch (unforeseen: Throwable) { // an unexpected error must not end this thread
                report("the graph at $place is left, and joined again: $unforeseen")
                RETRY_MS
            }
            val endNanos = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(restMs)
            while (!isClosed && endNanos - clock.nanos() > 0) awaitNews(endNanos - clock.nanos())
        }
        farewell.close()
    }

    /** Takes part in the graph until the connection ends or this object is closed. Returns the wait in ms before the next attempt. */
    private fun visit(): Long {
        val connection = Connection()
        connection.bridge = BridgeSocket.connect(place, address.ros.socket, connection, address.credentials)
        report("ROS sees ${participant.name} as /${participant.name} at $place")
        try {
            connection.begin()
            while (!isClosed && connection.end == null) {
                connection.goOn()
                awaitNews(TICK_NANOS)
            }
            connection.end?.let { report("$it; /${participant.name} is advertised again as soon as it is there") }
        } finally {
            connection.leave()
        }
        return connection.restMs
    }

    private fun awaitNews(nanos: Long) {
        news.tryAcquire(nanos, TimeUnit.NANOSECONDS)
        news.drainPermits()
    }

    private fun report(line: String) {
        if (line == reported) return
        reported = line
        lines.report("state") { more -> tell(foreignText(line) + more) }
    }

    /** Leaves the graph. Does not wait. */
    override fun close() {
        isClosed = true
        news.release()
    }

    private inner class Connection : BridgeListener(warn) {
        lateinit var bridge: Bridge
        private val api = RosApi(clock, ::send)
        private val advertised = AdvertisedServices(participant, ::answer, warn)
        private val advertisement = AdvertisementCheck(api, warn) {
            restMs = REJOINING_MS
            gone("the graph at $place has lost its topics, as after a restart of roscore")
        }
        private val unsent = AtomicInteger()
        private val rounds = MessageRounds(topics, clock) { checkNanos = clock.nanos() + FIRST_CHECK_NANOS }
        private var checkNanos = clock.nanos() + FIRST_CHECK_NANOS // used only by the thread

        @Volatile
        var end: String? = null

        @Volatile
        var restMs = RETRY_MS

        fun begin() {
            topics.renew()
            advertised.renew() // before the action is announced, since a goal may come at once
            api.ask("/rosapi/get_ros_version").whenComplete { answer, _ -> advertised.announceAction(answer?.text("version") == "2") }
        }

        fun goOn() {
            val now = clock.nanos()
            if (advertised.renew()) checkNanos = now + FIRST_CHECK_NANOS
            if (checkNanos - now <= 0) {
                checkNanos = now + CHECK_NANOS
                advertisement.check(rounds.advertised + advertised.topics, advertised.services)
            }
            if (!rounds.goOn(bridge)) gone("the bridge at $place has not answered a ping for ${MessageRounds.ANSWER_S} s")
        }

        private fun send(message: Outgoing) = bridge.send(message)

        /** Sends an answer ahead of the waiting messages. Closes the connection if the bridge requests answers but does not read them. */
        private fun answer(operation: String) {
            if (unsent.incrementAndGet() > MAX_UNSENT) return gone("the bridge at $place does not read what it asks for")
            val message = Outgoing(operation, isUrgent = true)
            message.left.whenComplete { _, _ -> unsent.decrementAndGet() }
            send(message)
        }

        override fun hear(operation: JsonObject) = api.heard(operation, clock.nanos()) || advertised.hear(operation)

        override fun isAlive() = Unit

        override fun answered() {
            rounds.answered()
            news.release()
        }

        override fun gone(reason: String) {
            if (end == null) end = reason
            news.release()
        }

        fun leave() {
            if (end == null) {
                advertised.takeAllBack()
                val last = Outgoing(operation("unadvertise", "topic" to "/${participant.name}/percepts")) // the bridge withdraws the rest
                bridge.send(last)
                try {
                    last.left.get(CLOSING_MS, TimeUnit.MILLISECONDS)
                } catch (_: TimeoutException) {
                    tell("the bridge at $place reads nothing, and goes on showing the services of /${participant.name}")
                } catch (_: ExecutionException) {
                    // the bridge no longer answers
                }
            }
            api.close()
            bridge.close()
        }
    }

    private companion object {
        const val RETRY_MS = 1_000L

        /**
         * After this wait, a ROS 1 bridge has dropped the publishers of the last connection. The bridge keeps a client's publishers for ten
         * seconds, even if the graph is new.
         */
        const val REJOINING_MS = 12_000L
        const val LEAVING_MS = 2_000L
        const val CLOSING_MS = 1_000L
        const val MAX_UNSENT = 1_000
        val TICK_NANOS = TimeUnit.MILLISECONDS.toNanos(250)
        val FIRST_CHECK_NANOS = TimeUnit.SECONDS.toNanos(3)
        val CHECK_NANOS = TimeUnit.SECONDS.toNanos(5)
    }
}
