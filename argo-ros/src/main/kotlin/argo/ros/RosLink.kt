package argo.ros

import argo.links.BoardLink
import argo.links.BoardMessage
import argo.links.SentCommand
import argo.links.Wish
import argo.ros.bridge.Bridge
import argo.ros.bridge.BridgeListener
import argo.ros.bridge.BridgeSocket
import argo.ros.bridge.ClockOffset
import argo.ros.bridge.Commands
import argo.ros.bridge.NeverSent
import argo.ros.bridge.Outgoing
import argo.ros.bridge.RosApi
import argo.ros.bridge.SilentTopics
import argo.ros.bridge.Subscription
import argo.ros.bridge.TopicMessages
import argo.ros.bridge.operation
import argo.ros.bridge.operationIn
import argo.ros.bridge.part
import argo.ros.bridge.rosNanos
import argo.ros.bridge.subscriptions
import argo.ros.bridge.text
import argo.ros.mapping.Mapping
import argo.ros.mapping.MappingException
import javino.LineClock
import javino.PortException
import javino.PortFaultException
import javino.PortGoneException
import javino.PortInterruptedException
import javino.PortTimeoutException
import javino.SendOptions
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonObject
import java.net.URI
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.logging.Logger
import kotlin.concurrent.withLock

/**
 * A robot behind a bridge of the rosbridge protocol. What it says is the newest message of each topic that the agent's filter lets through.
 *
 * A thread of the HTTP client takes messages in, and keeps the newest; the sensing thread makes percepts of them. So a message waits for
 * nobody, and none waits behind another.
 */
internal class RosLink private constructor(
    override val port: String,
    private val mapping: Mapping,
    override val isPaced: Boolean,
    private val clock: LineClock,
) : BoardLink {
    private val lock = clock.newLock(false)
    private val changed = lock.newCondition()
    private val warned = HashSet<String>() // guarded by lock, as all below

    private val topics = TopicMessages(mapping.percepts) { warn("${mapping.source}: $it") }
    private var subscribed: Map<String, Subscription> = emptyMap()
    private val silent = SilentTopics()
    private var aliveNanos = clock.nanos()
    private var end: String? = null

    private val clockOffset = ClockOffset()
    private val commands = Commands(port, mapping.commands, clock, ::send)
    private val api = RosApi(clock, clockOffset, ::send, ::warn) { LOG.info("port $port: $it") }

    @Volatile
    private var bridge: Bridge? = null

    override val isOpen: Boolean get() = lock.withLock { end == null }
    override val speaksUnasked get() = true
    override val mayVanish get() = true
    override val actions: List<BoardAction> = mapping.commands.map { BoardAction(it.name, it.parameters.size) }

    private inner class Listener : BridgeListener {
        override fun text(message: String) {
            val now = clock.nanos()
            val operation = operationIn(message)
            if (operation == null) warn("the bridge sends what is no operation of the rosbridge protocol: \"${message.take(QUOTED)}\"")
            else hear(operation, now)
        }

        override fun isAlive() = lock.withLock {
            aliveNanos = clock.nanos()
            changed.signalAll()
        }

        override fun gone(reason: String) = this@RosLink.gone(reason)
    }

    private fun hear(operation: JsonObject, nowNanos: Long) {
        if (commands.heard(operation) || api.heard(operation, nowNanos)) return
        when (operation.text("op")) {
            "publish" -> published(operation, nowNanos)
            "status" -> if (operation.text("level") in TROUBLE) warn("the bridge reports: ${operation.text("msg")}")
        }
    }

    private fun published(operation: JsonObject, nowNanos: Long) {
        val topic = operation.text("topic") ?: return
        val message = operation.part("msg") ?: return
        val trueNanos = clockOffset.trueAt(message.part("header")?.part("stamp")?.rosNanos(), nowNanos)
        lock.withLock {
            if (topic !in subscribed) return
            topics.add(topic, message, trueNanos, nowNanos)
            silent.heard(topic, nowNanos)
            changed.signalAll()
        }
    }

    override fun wants(wish: Wish) {
        val wanted = wish.subscriptions(mapping.percepts).associateBy { it.topic }
        val bridge = bridge ?: return
        lock.withLock {
            if (end != null) return
            val left = subscribed.keys - wanted.keys
            val news = left.map { operation("unsubscribe", "id" to it, "topic" to it) } +
                wanted.values.filter { subscribed[it.topic] != it }.map(::subscriptionTo)
            news.forEach { bridge.queue(Outgoing(it)) }
            subscribed = wanted
            silent.keepOnly(wanted.keys, clock.nanos())
            topics.keepOnly(wanted.keys)
            changed.signalAll()
        }
        bridge.flush()
    }

    private fun subscriptionTo(one: Subscription) = operation(
        "subscribe", "id" to one.topic, "topic" to one.topic, "type" to one.type, "throttle_rate" to one.throttleMs, "queue_length" to 1,
    )

    /** Waits for a message of a topic. While there is none, the bridge is asked halfway whether it is there. */
    override fun listen(timeoutMs: Int): BoardMessage? {
        api.renew()
        lock.withLock { silent.next(clock.nanos()).mapNotNull(subscribed::get) }.forEach { api.explainSilence(it.topic, it.type) }
        return lock.withLock { next(timeoutMs) }
    }

    private fun next(timeoutMs: Int): BoardMessage? {
        val start = clock.nanos()
        val end = start + TimeUnit.MILLISECONDS.toNanos(timeoutMs.toLong())
        val half = start + (end - start) / 2
        var isAsked = false
        while (true) {
            requireOpen()
            val now = clock.nanos()
            if (topics.hasNews(now)) return topics.take(now)
            if (now - end >= 0) return silence(start, timeoutMs)
            if (now - half >= 0 && !isAsked) {
                isAsked = true
                if (aliveNanos - start < 0) bridge?.ping()
            }
            await(listOfNotNull(if (isAsked) end else half, topics.dueNanos()).minOf { it - now })
        }
    }

    /** No topic has said anything since [startNanos]; null, unless the bridge has not shown either that it is there. */
    private fun silence(startNanos: Long, timeoutMs: Int): BoardMessage? {
        val now = clock.nanos()
        if (aliveNanos - startNanos < 0) throw PortTimeoutException(port, "the bridge at port $port has not answered within $timeoutMs ms")
        return if (subscribed.isEmpty()) topics.take(now) else null // where nothing is wanted of it, it is enough that it is there
    }

    private fun await(nanos: Long) {
        try {
            clock.await(changed, maxOf(1, nanos))
        } catch (_: InterruptedException) {
            throw PortInterruptedException.remarking(port)
        }
    }

    override fun check() = lock.withLock { requireOpen() }

    private fun requireOpen() {
        end?.let { throw PortGoneException(port, "port $port is gone: $it") }
    }

    override fun send(text: String, options: SendOptions): SentCommand = commands.send(text, options)

    override fun sendAndAwait(text: String, options: SendOptions) {
        try {
            send(text, options).outcome.get()
        } catch (failed: ExecutionException) {
            throw failed.cause ?: failed
        } catch (_: InterruptedException) {
            throw PortInterruptedException.remarking(port)
        }
    }

    private fun send(text: String) = send(Outgoing(text))

    private fun send(message: Outgoing) {
        val bridge = bridge
        val isOver = bridge == null || !isOpen // the socket may still take it and lose it
        if (isOver) message.left.completeExceptionally(NeverSent()) else bridge.send(message)
    }

    private fun warn(message: String) {
        if (lock.withLock { warned.size < MAX_WARNED && warned.add(message) }) LOG.warning("port $port: $message")
    }

    private fun gone(reason: String) {
        lock.withLock {
            if (end != null) return
            end = reason
            topics.clear()
            changed.signalAll()
        }
        api.close()
        commands.gone(reason)
        bridge?.close()
    }

    override fun close() = gone("it was closed")

    companion object {
        private val LOG: Logger = Logger.getLogger(RosLink::class.java.name)
        private val TROUBLE = setOf("error", "warning")
        private const val QUOTED = 60
        private const val MAX_WARNED = 100
        private const val CHECKING_MS = 1_000L

        /**
         * Connects to the bridge at [address], and has the fields of [mapping] checked against what the bridge knows of their types, if it
         * does.
         *
         * @param token what the bridge is shown; null: nothing
         * @throws PortException if there is no bridge, or a field is none
         */
        fun open(port: String, address: URI, mapping: Mapping, isPaced: Boolean, clock: LineClock, token: String? = null): RosLink =
            over(port, mapping, isPaced, clock) { BridgeSocket.connect(port, address, it, token) }

        /** As [open], over the connection that [connect] makes. */
        fun over(port: String, mapping: Mapping, isPaced: Boolean, clock: LineClock, connect: (BridgeListener) -> Bridge): RosLink {
            val link = RosLink(port, mapping, isPaced, clock)
            var isOpened = false
            try {
                link.bridge = connect(link.Listener())
                link.begin()
                isOpened = true
                return link
            } catch (refused: MappingException) {
                throw PortFaultException(port, "port $port cannot be opened: ${refused.message}", refused)
            } finally {
                if (!isOpened) link.abandon()
            }
        }
    }

    /** The connection may have ended before it was this link's. */
    private fun abandon() {
        close()
        bridge?.close()
    }

    private fun begin() {
        commands.announcements().forEach(::send)
        try {
            api.check(mapping, CHECKING_MS)
        } catch (_: InterruptedException) {
            throw PortInterruptedException.remarking(port)
        }
        check()
    }
}
