package argo.ros

import argo.links.Answer
import argo.links.BoardLink
import argo.links.BoardMessage
import argo.links.SentCommand
import argo.links.Wish
import argo.ros.bridge.Bridge
import argo.ros.bridge.BridgeListener
import argo.ros.bridge.Commands
import argo.ros.bridge.FrameTree
import argo.ros.bridge.LimitedWarnings
import argo.ros.bridge.NeverSent
import argo.ros.bridge.Outgoing
import argo.ros.bridge.RobotGraph
import argo.ros.bridge.RobotTime
import argo.ros.bridge.RobotTypes
import argo.ros.bridge.RosApi
import argo.ros.bridge.SilentTopics
import argo.ros.bridge.SimulatedClock
import argo.ros.bridge.Subscription
import argo.ros.bridge.TopicMessages
import argo.ros.bridge.operation
import argo.ros.bridge.part
import argo.ros.bridge.rosNanos
import argo.ros.bridge.subscriptions
import argo.ros.bridge.text
import argo.ros.mapping.Frames
import argo.ros.mapping.Mapping
import argo.ros.mapping.MappingException
import argo.ros.mapping.PerceptRule
import javino.LineClock
import javino.PortException
import javino.PortFaultException
import javino.PortGoneException
import javino.PortInterruptedException
import javino.PortTimeoutException
import javino.link.SendOptions
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonObject
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.logging.Level
import java.util.logging.Logger
import kotlin.concurrent.withLock

/**
 * A robot behind a bridge of the rosbridge protocol. The link subscribes to the topics of the mapping. The link skips topics whose percepts
 * the agent's filter drops completely.
 *
 * A thread of the HTTP client receives messages and keeps the newest ones. The sensing thread turns messages into percepts.
 */
internal class RosLink private constructor(
    override val port: String,
    private val mapping: Mapping,
    override val isPaced: Boolean,
    private val clock: LineClock,
    private val log: (Level, String) -> Unit,
) : BoardLink {
    private val lock = clock.newLock(false)
    private val changed = lock.newCondition()
    private val warn = LimitedWarnings { log(Level.WARNING, "port $port: $it") }

    private val api = RosApi(clock, ::send)
    private val types = RobotTypes(mapping, api, warn, ::tell)
    private val graph = RobotGraph(mapping, api, clock, warn)
    private val time = RobotTime(clock, api, ::clockIsThere, warn, ::tell)
    private val commands = Commands(port, mapping.commands, types, graph, clock, ::send, warn, ::progress)

    // the lock guards this field and all non-volatile fields below
    private val poses = mapping.poses.distinctBy { it.topic } // several rules may use one pose
    private val topics = TopicMessages(mapping.percepts + mapping.feedback, types::of) { warn("${mapping.source}: $it") }
    private val perceived = mapping.percepts.map { it.topic }.toSet()
    private val frames = FrameTree(mapping.poses.mapNotNull { it.frames }) { warn("${mapping.source}: $it") }
    private var wish: Wish? = null
    private var clockType: String? = null // the type of the topic /clock; null if the robot has no such topic
    private var subscribed: Map<String, Subscription> = emptyMap()
    private val silent = SilentTopics()
    private var end: String? = null

    @Volatile
    private var aliveNanos = clock.nanos()

    @Volatile
    private var bridge: Bridge? = null

    override val isOpen: Boolean get() = lock.withLock { end == null }
    override val speaksUnasked get() = true
    override val mayVanish get() = true
    override val actions: List<BoardAction> = mapping.commands.map { BoardAction(it.name, it.parameters.size) }

    private inner class Listener : BridgeListener(warn) {
        override fun hear(operation: JsonObject): Boolean {
            val now = clock.nanos()
            if (commands.heard(operation) || api.heard(operation, now)) return true
            when (operation.text("op")) {
                "publish" -> published(operation, now)
                "service_response", "action_result" ->
                    warn("an answer came for a command whose time was over, or whose intention was dropped; it is not used")
                else -> return false
            }
            return true
        }

        override fun isAlive() {
            aliveNanos = clock.nanos() // a waiting thread reads this value when its wait ends
        }

        override fun told(sentence: String, isTrouble: Boolean) = if (isTrouble) warn(sentence) else tell(sentence)

        override fun gone(reason: String) = this@RosLink.gone(reason)
    }

    private fun published(operation: JsonObject, nowNanos: Long) {
        val topic = operation.text("topic")
        val message = operation.part("msg")
        if (topic == null || message == null) return warn("the bridge sends a message without a topic, or without fields; it is not read")
        if (topic == RobotTime.CLOCK) message.part("clock")?.rosNanos()?.let { time.show(it, nowNanos) }
        val trueNanos = time.trueAt(topic, message.part("header")?.part("stamp")?.rosNanos(), nowNanos)
        lock.withLock {
            if (topic !in subscribed) return // the bridge sent the message before it handled the unsubscription
            silent.heard(topic, nowNanos)
            if (topic in Frames.TOPICS) moved(message, topic, nowNanos)
            if (topic in perceived) topics.add(topic, message, trueNanos, nowNanos)
            changed.signalAll()
        }
    }

    private fun moved(message: JsonObject, topic: String, nowNanos: Long) {
        frames.add(message, topic == Frames.STATIC, nowNanos) { stamp -> time.trueAt(topic, stamp, nowNanos) }
        for (rule in poses) {
            val pose = frames.pose(checkNotNull(rule.frames), nowNanos) ?: continue
            topics.add(rule.topic, pose.json, pose.trueNanos, nowNanos)
        }
    }

    /** Stores the newest [feedback] of a goal. Null means that the goal has ended. */
    private fun progress(rule: PerceptRule, feedback: JsonObject?) = lock.withLock {
        val now = clock.nanos()
        if (feedback == null) topics.forget(rule.topic) else if (wish?.isSensed == true) topics.add(rule.topic, feedback, now, now)
        changed.signalAll()
    }

    private fun clockIsThere(type: String) {
        lock.withLock {
            clockType = type
            wish
        }?.let(::wants)
    }

    private fun wantedFor(wish: Wish): Map<String, Subscription> {
        val wanted = wish.subscriptions(mapping.percepts).associateBy { it.topic }
        val type = clockType?.takeIf { wish.isSensed && RobotTime.CLOCK !in wanted } ?: return wanted
        return wanted + (RobotTime.CLOCK to Subscription(RobotTime.CLOCK, type, SimulatedClock.INTERVAL_MS))
    }

    override fun wants(wish: Wish) {
        val bridge = bridge ?: return
        lock.withLock {
            if (end != null) return
            this.wish = wish
            val wanted = wantedFor(wish)
            val left = subscribed.keys - wanted.keys
            val news = left.map { operation("unsubscribe", "id" to it, "topic" to it) } +
                wanted.values.filter { subscribed[it.topic] != it }.map(::subscriptionTo)
            news.forEach { bridge.queue(Outgoing(it)) }
            subscribed = wanted
            silent.keepOnly(wanted.keys, clock.nanos())
            topics.keepOnly(wanted.keys + if (wish.isSensed) (mapping.feedback + mapping.poses).map { it.topic } else emptyList())
            topics.intervalNanos = TimeUnit.MILLISECONDS.toNanos(wish.intervalMs.toLong())
            changed.signalAll()
        }
        bridge.flush()
    }

    private fun subscriptionTo(one: Subscription) = operation(
        "subscribe", "id" to one.topic, "topic" to one.topic, "type" to one.type, "throttle_rate" to one.throttleMs,
        "queue_length" to one.queueLength,
    )

    /** Waits for a message. If none comes within half of [timeoutMs], pings the bridge. */
    override fun listen(timeoutMs: Int): BoardMessage? {
        time.renew()
        explain(lock.withLock { silent.next(clock.nanos()) })
        return lock.withLock { next(timeoutMs) }
    }

    fun explainSilence() = explain(
        lock.withLock {
            frames.explain()
            subscribed.keys.filterNot(topics::hasHeard)
        },
    )

    private fun explain(silentTopics: Collection<String>) = lock.withLock { silentTopics.mapNotNull(subscribed::get) }
        .filter { it.topic != Frames.STATIC }.forEach { graph.explainSilence(it.topic, it.type) }

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

    /**
     * Ends a wait in which no message has come since [startNanos]. Without subscriptions, returns the current percepts; otherwise returns
     * null. Throws a [PortTimeoutException] if the bridge has given no sign of life during the wait.
     */
    private fun silence(startNanos: Long, timeoutMs: Int): BoardMessage? {
        val now = clock.nanos()
        if (aliveNanos - startNanos < 0) throw PortTimeoutException(port, "the bridge at port $port has not answered within $timeoutMs ms")
        return if (subscribed.isEmpty()) topics.take(now) else null // without subscriptions, a living bridge is enough
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

    override fun answers(text: String) = commands.answers(text)

    override fun send(text: String, options: SendOptions): SentCommand = commands.send(text, options)

    override fun sendAndAwait(text: String, options: SendOptions): Answer? {
        try {
            return send(text, options).outcome.get() as? Answer
        } catch (failed: ExecutionException) {
            throw failed.cause ?: failed
        } catch (_: InterruptedException) {
            throw PortInterruptedException.remarking(port)
        }
    }

    private fun send(message: Outgoing) {
        val bridge = bridge
        val isOver = bridge == null || !isOpen // a closing socket may accept the command and lose it
        if (isOver) message.left.completeExceptionally(NeverSent()) else bridge.send(message)
    }

    private fun tell(message: String) = log(Level.INFO, "port $port: $message")

    /** Ends the link. Closes the connection after [farewell] was sent, at the latest after [FAREWELL_NANOS]. */
    private fun gone(reason: String, farewell: List<Outgoing> = emptyList()) {
        lock.withLock {
            if (end != null) return
            end = reason
            topics.clear()
            changed.signalAll()
        }
        api.close()
        commands.gone(reason)
        CompletableFuture.allOf(*farewell.map { it.left }.toTypedArray()).whenComplete { _, _ -> bridge?.close() }
        if (farewell.isNotEmpty()) clock.schedule(FAREWELL_NANOS) { bridge?.close() }
    }

    override fun close() = gone("it was closed", if (isOpen) commands.cancellations().onEach(::send) else emptyList())

    companion object {
        /** The log of all robots. Jason shows only the last part of its name, `ros`. */
        private val LOG: Logger = Logger.getLogger(RosLink::class.java.packageName)
        private const val CHECKING_MS = 3_000L
        private val FAREWELL_NANOS = TimeUnit.SECONDS.toNanos(1)

        /**
         * Opens a link over the connection that [connect] makes. Checks the fields of [mapping] against the types that the bridge
         * describes. Several threads call [log] with messages for the user.
         *
         * @throws PortException if no bridge answers, or if a field does not exist
         */
        fun over(
            port: String,
            mapping: Mapping,
            isPaced: Boolean,
            clock: LineClock,
            log: (Level, String) -> Unit = LOG::log,
            connect: (BridgeListener) -> Bridge,
        ): RosLink {
            val link = RosLink(port, mapping, isPaced, clock, log)
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

    private fun abandon() {
        close()
        bridge?.close()
    }

    private fun begin() {
        commands.announcements().forEach { send(Outgoing(it)) }
        time.ask()
        graph.check()
        mapping.doubts.forEach(warn)
        try {
            types.check(CHECKING_MS)
        } catch (_: InterruptedException) {
            throw PortInterruptedException.remarking(port)
        }
        check()
    }
}
