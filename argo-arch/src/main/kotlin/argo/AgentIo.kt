package argo

import argo.acting.BoardRules
import argo.acting.CommandLedger
import argo.acting.CommandOptions
import argo.acting.CommandSender
import argo.acting.Reflexes
import argo.calls.Failure
import argo.connecting.OpenPort
import argo.connecting.PortOptions
import argo.connecting.PortStates
import argo.connecting.PortStatus
import argo.connecting.PortUser
import argo.connecting.Ports
import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import argo.observing.Observers
import argo.observing.RuleWatcher
import argo.observing.WatchedRule
import argo.perception.BeliefReader
import argo.perception.BoardPercepts
import argo.perception.EveryHandOver
import argo.perception.FreshHandOver
import argo.perception.HandOver
import argo.perception.LastSeen
import argo.perception.PerceptEvents
import argo.perception.PerceptIntentions
import argo.perception.PerceptLimit
import argo.perception.Snapshot
import argo.platform.Platform
import argo.platform.RateLimitedWarning
import argo.platform.Waker
import argo.platform.nowMs
import argo.sensing.Sensing
import argo.sensing.SensingListener
import argo.sensing.SensingPolicy
import argo.sensing.StaleBeliefs
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.bb.BeliefBase
import javino.BoardListener
import javino.PerceptsRequest
import javino.PortException
import javino.PortTimeoutException
import javino.Protocol
import javino.wire.ReflexOutcome
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicReference
import java.util.logging.Level
import java.util.logging.Logger
import javino.wire.BoardAction as RegisteredAction

/**
 * The boards of one agent: its ports, what it perceives through the one in use, and the commands it sends. [Arch] connects it with Jason.
 *
 * Whether the agent perceives, how often, and the port in use are each written by one thread at a time and read where they are needed;
 * nobody keeps a copy. After each change those who wait are woken to read again. Functions belong to the agent's thread unless they say
 * otherwise.
 *
 * @param owner the agent's name
 * @param events the percept events in Jason's queue
 * @param intentions the intentions that such events have begun
 * @param observers the agent's observers
 */
internal class AgentIo(
    owner: String,
    options: ArchOptions,
    private val platform: Platform,
    private val waker: Waker,
    private val log: Logger,
    events: PerceptEvents,
    intentions: PerceptIntentions,
    private val observers: () -> Observers,
) {
    /** Whether the agent perceives its board. Any thread may read. */
    @Volatile
    var isPerceiving = false
        private set

    /** The sensing interval in ms. Any thread may read. */
    @Volatile
    var intervalMs = DEFAULT_INTERVAL_MS
        private set

    @Volatile
    private var sensed: List<Literal> = emptyList()
    private val activities = ConcurrentHashMap<OpenPort, Activity>()
    private val coupling = if (options.policy == SensingPolicy.IN_CYCLE) InCycle(platform, waker) else Decoupled
    private val activePort = AtomicReference<OpenPort?>()
    private val ledger = CommandLedger(::portInUse)
    private val handOver: HandOver =
        if (options.policy == SensingPolicy.FRESH) FreshHandOver(ledger, events, intentions) else EveryHandOver { log.warning(it) }
    private val lastSeen = LastSeen { sensed }
    private val stale = StaleBeliefs(platform.nowMs, { portInUse()?.takeIf { isPerceiving } }, ::intervalMs)
    private val reflexes: Reflexes = Reflexes(::sendReflex, ::isWatchedBy, ::reflexEnded, rateLimitedWarning())
    private val percepts: BoardPercepts = BoardPercepts(
        platform.clock.newLock(false), ::isPerceived, handOver, reflexes,
        { observers().messageFiltered(it) }, BeliefReader { log.warning(it) }, log,
        PerceptLimit(options.maxPercepts, rateLimitedWarning()), lastSeen, platform.nowMs,
    )

    /** The states of the ports. Any thread. */
    val states = PortStates(::portChanged)
    private val ports = Ports(owner, states, User(owner), coupling.isPaced, platform) { log.warning(it) }

    private var newlyCritical: List<Literal> = emptyList()

    private fun rateLimitedWarning() = RateLimitedWarning(platform.nowMs) { log.warning(it) }

    /** The port in use, or null. Any thread. */
    fun portInUse(): OpenPort? = ports.current

    /** The actions that the board in use has registered; null: they are not known. Any thread. */
    fun vocabulary(): List<RegisteredAction>? = portInUse()?.link?.vocabulary()?.orElse(null)?.takeIf { it.isNotEmpty() }

    /** Makes [name] the port in use: see [Ports.choose]. */
    fun choosePort(term: Term, name: String, options: PortOptions?, outcome: (Failure?) -> Unit) =
        ports.choose(term, name, options, outcome)

    /** Closes all ports; [closed] is called by another thread. */
    fun closePorts(closed: () -> Unit) = ports.closeAll(closed)

    /** Perceives through [filter] from the next perception on; null: everything. */
    fun perceiveThrough(filter: PerceptionFilter?) {
        percepts.switchTo(filter)
        renewRules()
    }

    /** Why the active filter keeps or drops [percept], and who watches the critical rule that decides. Any thread. */
    fun explain(percept: String): String {
        val explanation = percepts.explain(percept)
        val critical = criticalRules().find { it.rule.rule === explanation.rule } ?: return "$explanation"
        return "$explanation; ${critical.watcher.word} watches it"
    }

    /** The critical rules of the active filter, and who watches each. Any thread. */
    fun criticalRules(): List<WatchedRule> {
        val port = portInUse()
        return percepts.critical.map {
            WatchedRule(it, if (port != null && isWatchedBy(port, it)) RuleWatcher.BOARD else RuleWatcher.COMPUTER)
        }
    }

    /** Whether the board on [port] watches [rule] itself. */
    private fun isWatchedBy(port: OpenPort, rule: CriticalRule) = activities[port]?.rules?.isWatching(rule) == true

    private fun renewRules() = activities.values.forEach { it.rules.renew() }

    private fun reflexEnded(rule: CriticalRule, watcher: RuleWatcher, failure: Failure?) {
        observers().reflexEnded(rule, watcher, failure)
        waker.wake { !reflexes.hasNews() }
    }

    /** The youngest percept in [beliefs] that unifies with [percept] under [un], and its age in ms; null if there is none. */
    fun youngest(beliefs: BeliefBase, percept: Literal, un: Unifier): Pair<Literal, Long>? {
        val now = platform.clock.nanos()
        return lastSeen.youngest(beliefs, percept, un, now)?.let { (belief, seen) -> belief to TimeUnit.NANOSECONDS.toMillis(now - seen) }
    }

    /** Starts or stops perceiving. When it has stopped no further reflex is sent; a board carries its own out until that is removed. */
    fun perceive(open: Boolean) {
        if (isPerceiving == open) return
        isPerceiving = open
        stale.renew()
        beginAnew()
        dueInMs()?.let(waker::wakeIn) // the agent may fall asleep before it perceives
    }

    /** Sets the sensing interval in ms; 0: as fast as the line allows. */
    fun senseEvery(intervalMs: Int) {
        this.intervalMs = intervalMs
        wakeSensing()
    }

    /**
     * Sends [text] to the board on [port].
     *
     * @param outcome is called once, by any thread, with null when the last byte has left the line or a version 2 board has acted, else
     *     with the reason why not
     */
    fun send(port: OpenPort, text: String, options: CommandOptions, outcome: (Failure?) -> Unit) {
        val number = ledger.issue(port)
        transmit(port, text, options) {
            ledger.done(port, number)
            outcome(it)
        }
    }

    /** Sends a reflex. No snapshot waits for it, since the agent has not issued it. */
    private fun sendReflex(port: OpenPort, command: String, outcome: (Failure?) -> Unit) =
        transmit(port, command, CommandOptions(urgent = true), outcome)

    private fun transmit(port: OpenPort, text: String, options: CommandOptions, outcome: (Failure?) -> Unit) {
        val report = observers().commandIssued(port.link.port(), text, outcome)
        val commands = activities[port]?.commands
            ?: return report(Failure("port_gone", "port ${port.link.port()} was closed, or its device has gone"))
        coupling.submit(commands, text, options, report)
    }

    /** Takes in what is new for the agent since the last call, and returns whether [beliefs] may have changed. */
    fun update(): Boolean {
        coupling.perceiving(portInUse()?.takeIf { isPerceiving && it.link.isOpen }?.let { activities[it]?.sensing }, intervalMs)
        if (isPerceiving) percepts.putDue()
        val snapshot = handOver.take()?.takeIf { it.port == null || isPerceived(it.port) }
        snapshot?.let(::handOver)
        newlyCritical = snapshot?.critical.orEmpty().map { it.percept }
        val isStaleNews = stale.update()
        return snapshot != null || isStaleNews || states.hasNews() || reflexes.hasNews()
    }

    private fun handOver(snapshot: Snapshot) {
        sensed = snapshot.percepts
        observers().messagePerceived(snapshot)
    }

    /** What is critical in the snapshot that the last [update] handed over; empty when asked again. */
    fun takeNewlyCritical(): List<Literal> = newlyCritical.also { newlyCritical = emptyList() }

    /** The beliefs about the board in use, about the ports, and about the outcomes of reflexes. */
    fun beliefs(): List<Literal> = sensed + states.beliefs() + stale.beliefs() + reflexes.beliefs()

    /** The time in ms until [update] has something to do without news from a board; null: it will not have. */
    fun dueInMs(): Long? = listOfNotNull(percepts.dueInMs().takeIf { isPerceiving }, stale.dueInMs().takeIf { it != 0L }).minOrNull()

    /** Whether [update] has something to do now. Any thread. */
    fun hasNews(): Boolean = handOver.isReady() || states.hasNews() || stale.hasNews() || reflexes.hasNews() ||
        isPerceiving && percepts.dueInMs() == 0L

    /** Whether the agent believes that [port] is stale. Any thread. */
    fun isStale(port: Term): Boolean = stale.isStale(port)

    /** Gives up all ports and threads. Never waits for a line. Any thread; may be called twice. */
    fun stop() = ports.stop()

    /** Whether the agent perceives the board on [port]. Any thread. */
    private fun isPerceived(port: OpenPort) = isPerceiving && port === portInUse()

    private fun wakeSensing() = activities.values.forEach { it.sensing.wake() }

    /** What was sensed so far and has not been perceived is of another time or place. Any thread. */
    private fun beginAnew() {
        percepts.forget()
        renewRules()
        wakeSensing()
    }

    private fun portChanged(port: Term, status: PortStatus, reason: String?) {
        val level = if (status == PortStatus.ON) Level.INFO else Level.WARNING
        observers().portChanged("$port", status.word, reason)
        log.log(level, "port $port is ${status.word}" + reason?.let { ": $it" }.orEmpty())
        waker.wake { !states.hasNews() }
    }

    /** What works through one open port. */
    private inner class Activity(
        private val port: OpenPort,
        val commands: CommandSender,
        val sensing: Sensing,
    ) : BoardListener, AutoCloseable {
        val rules = BoardRules(
            { percepts.critical.takeIf { coupling.isPaced && isPerceived(port) }.orEmpty() },
            { command, outcome -> commands.submit(command, CommandOptions(urgent = true), outcome) },
        )

        override fun sessionBegan(room: Int) = rules.began(room)

        override fun critical(rule: Int, outcome: ReflexOutcome, percept: String, receivedNanos: Long) {
            val critical = rules.ruleOf(rule) ?: return
            if (percepts.reported(port, critical, outcome, percept, receivedNanos)) waker.wake { !handOver.isReady() }
        }

        override fun close() {
            sensing.close()
            activities -= port
        }
    }

    private inner class User(private val owner: String) : PortUser, SensingListener {
        override fun use(port: OpenPort): AutoCloseable {
            val commands = CommandSender(port.link, owner, platform) { lost(port, it) }
            return Activity(port, commands, Sensing(port, owner, this, platform)).also {
                activities[port] = it
                port.link.onBoardEvents(it)
            }
        }

        override fun opened(port: OpenPort) {
            activities[port]?.sensing?.start()
        }

        override fun portInUseChanged() {
            val current = portInUse()
            val before = activePort.getAndSet(current)
            if (!isSame(before, current)) stale.renew() // the beliefs of a port that has come back are as old as they were
            beginAnew()
        }

        /** Whether the agent has one name for both, so that they are one port, which may have been opened again. */
        private fun isSame(before: OpenPort?, current: OpenPort?) =
            before != null && current != null && before.terms.any { it in current.terms }

        override val intervalMs get() = this@AgentIo.intervalMs

        override fun isSensed(port: OpenPort) = isPerceived(port)

        override fun request(port: OpenPort) = if (port.link.protocol() == Protocol.V2) percepts.request else PerceptsRequest.ALL

        override fun mayReport(port: OpenPort) = activities[port]?.rules?.isEmpty == false

        override fun received(port: OpenPort, message: String, askedNanos: Long, receivedNanos: Long) {
            if (!percepts.received(port, message, askedNanos, receivedNanos)) return
            stale.renew()
            waker.wake { !handOver.isReady() && stale.isEmpty() }
        }

        override fun unanswered(port: OpenPort, trouble: PortTimeoutException) = ports.report(port, PortStatus.TIMEOUT, trouble.message)

        override fun answeredAgain(port: OpenPort) = ports.report(port, PortStatus.ON)

        override fun lost(port: OpenPort, trouble: PortException) = ports.lost(port, trouble)
    }

    companion object {
        /** The sensing interval in ms until `argo.limit` sets another. */
        const val DEFAULT_INTERVAL_MS = 50
    }
}
