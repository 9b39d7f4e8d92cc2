package argo

import argo.acting.CommandLedger
import argo.acting.CommandOptions
import argo.acting.Commands
import argo.acting.Reflexes
import argo.calls.Failure
import argo.filters.PerceptionFilter
import argo.observing.AgentObserver
import argo.observing.Observers
import argo.perception.BeliefReader
import argo.perception.BoardPercepts
import argo.perception.EnvironmentPercepts
import argo.perception.EveryHandOver
import argo.perception.FreshHandOver
import argo.perception.HandOver
import argo.perception.LastSeen
import argo.perception.PerceptEvents
import argo.perception.PerceptLimit
import argo.perception.Snapshot
import argo.perception.bringForward
import argo.platform.Platform
import argo.platform.RateLimitedWarning
import argo.platform.Waker
import argo.platform.nowMs
import argo.ports.OpenPort
import argo.ports.PortOptions
import argo.ports.PortStates
import argo.ports.PortStatus
import argo.ports.Ports
import argo.sensing.InCycleSensing
import argo.sensing.SensingListener
import argo.sensing.SensingPolicy
import argo.sensing.StaleBeliefs
import jason.architecture.AgArch
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.infra.local.LocalAgArch
import javino.PerceptsRequest
import javino.PortException
import javino.PortTimeoutException
import javino.Protocol
import java.util.concurrent.atomic.AtomicReference
import java.util.logging.Level
import java.util.logging.Logger

/**
 * The architecture of an agent that perceives and acts through microcontroller boards. A project declares it in its `.mas2j`:
 *
 *     agents: robot agentArchClass argo.Arch;
 *
 * and its agents use the internal actions `argo.port`, `argo.limit`, `argo.percepts`, `argo.act`, `argo.change_filter`, `argo.age` and
 * `argo.explain`. Options: `[argo_sensing=fresh]` (the default), `every` or `in_cycle`, which is when snapshots of the sensors are handed
 * over; `argo_percepts=4096`, how many percepts are believed at once; and those of observers, such as `argo_view=8080` of the live view.
 *
 * It follows C. E. Pantoja et al., "ARGO: An Extended Jason Architecture that Facilitates Embedded Robotic Agents
 * Programming", EMAS 2016. No reasoning cycle waits for a line, but under `in_cycle`, which exists for comparison.
 *
 * The methods of [AgArch] are called by Jason; a project has no reason to call any.
 *
 * @param platform its time, threads and ports; Jason makes it with those of the machine
 */
open class Arch @JvmOverloads constructor(private val platform: Platform = Platform.system) : AgArch() {
    private lateinit var log: Logger
    private lateinit var board: BoardPercepts
    private lateinit var handOver: HandOver
    private lateinit var states: PortStates
    private lateinit var ports: Ports
    private lateinit var waker: Waker
    private lateinit var inCycle: InCycleSensing
    private val commands = CommandLedger()
    private val actedThrough = AtomicReference<OpenPort?>()
    private val environment = EnvironmentPercepts(nowMs = platform.nowMs)

    internal lateinit var policy: SensingPolicy
        private set

    /** Whether the agent perceives its board. */
    @Volatile
    internal var isPerceiving = false
        private set

    /** The sensing interval in ms. */
    @Volatile
    internal var intervalMs = DEFAULT_INTERVAL_MS
        private set
    private val stale = StaleBeliefs(platform.nowMs, { ports.current?.takeIf { isPerceiving } }, { intervalMs })

    @Volatile
    private var sensed: List<Literal> = emptyList()
    private val sightings = LastSeen { sensed }
    private lateinit var reflexes: Reflexes
    private var criticalNews: List<Literal> = emptyList()

    @Volatile
    private var observing = Observers(emptyList(), Logger.getLogger(Arch::class.java.name), platform.clock::nanos)

    /** The agent's observers, such as its live view. There from [init] on. Any thread may ask. */
    val observers: List<AgentObserver> get() = observing.observers

    override fun init() {
        super.init()
        log = Logger.getLogger("${Arch::class.java.name}.$agName")
        val options = ArchOptions(ts.settings, log)
        policy = options.policy
        waker = Waker(this, platform)
        inCycle = InCycleSensing(platform, waker)
        val rareWarning = { RateLimitedWarning(platform.nowMs) { log.warning(it) } }
        board = BoardPercepts(BeliefReader { log.warning(it) }, log, PerceptLimit(options.mostPercepts, rareWarning()), sightings, platform.nowMs)
        reflexes = Reflexes(::sendReflex, rareWarning())
        handOver = if (policy == SensingPolicy.FRESH) FreshHandOver(commands, PerceptEvents(::eventsStand, platform.nowMs) { ts.c.events }) else EveryHandOver { log.warning(it) }
        states = PortStates(::portChanged)
        ports = Ports(agName, states, Listener(), paced = policy != SensingPolicy.IN_CYCLE, platform, ::settle) { log.warning(it) }
        observing = Observers(options.observers.open(ObservedArch(this, states, stale, board, waker, platform)), log, platform.clock::nanos)
    }

    /** An atomic plan holds back all events; with `events=requeue` those that no plan applies to come back for ever. */
    private fun eventsStand() = ts.c.hasAtomicIntention() || ts.c.atomicEvent != null || ts.settings.requeue()

    /** Perceives through [filter] from the next perception on; null: everything. Called by the agent's thread. */
    internal fun perceiveThrough(filter: PerceptionFilter?) {
        board.switchTo(filter)
        reflexes.forget()
        environment.switchTo(filter)
        observing.filterChanged(filter)
    }

    /** Why the active filter does with [percept] what it does. */
    internal fun explain(percept: Literal): String = board.explain(percept)

    /** The youngest percept belief that unifies with [percept] under [un], and its age in ms; null if there is none. Called by the agent's thread. */
    internal fun youngest(percept: Literal, un: Unifier): Pair<Literal, Long>? {
        val now = platform.clock.nanos()
        return sightings.youngest(ts.ag.bb, percept, un, now)?.let { (belief, seen) -> belief to (now - seen) / NANOS_PER_MS }
    }

    /** Starts or stops perceiving. */
    internal fun perceive(open: Boolean) {
        if (isPerceiving == open) return
        isPerceiving = open
        stale.renew()
        senseAnew()
    }

    /** Sets the sensing interval in ms; 0: as fast as the line allows. */
    internal fun senseEvery(intervalMs: Int) {
        this.intervalMs = intervalMs
        applySensing()
    }

    /** Makes [name] the port in use: see [Ports.choose]. */
    internal fun choosePort(term: Term, name: String, options: PortOptions?, outcome: (Failure?) -> Unit) =
        ports.choose(term, name, options, outcome)

    /** Closes all ports; [closed] is called by another thread. */
    internal fun closePorts(closed: () -> Unit) = ports.closeAll(closed)

    /** The port in use, or null. */
    internal fun portInUse(): OpenPort? = ports.current

    /**
     * Sends [text] to the board on [port].
     * @param outcome is called once, with null when its last byte has left the line or the board has acted, else with the reason why it has not
     */
    internal fun send(port: OpenPort, text: String, options: CommandOptions, outcome: (Failure?) -> Unit) {
        val number = if (policy == SensingPolicy.IN_CYCLE) null else commands.issue()
        transmit(port, text, options) {
            number?.let(commands::done)
            outcome(it)
        }
    }

    /** Sends a reflex, which no snapshot waits for since the agent has not issued it. */
    private fun sendReflex(port: OpenPort, command: String, outcome: (Failure?) -> Unit) = transmit(port, command, CommandOptions(urgent = true), outcome)

    private fun transmit(port: OpenPort, text: String, options: CommandOptions, outcome: (Failure?) -> Unit) {
        val told = observing.commandIssued(port.link.port(), text, outcome)
        if (policy == SensingPolicy.IN_CYCLE) told(port.commands.write(text, options)) else port.commands.submit(text, options, told)
    }

    /** Wakes the agent until [seen]: see [Waker]. */
    internal fun wake(seen: () -> Boolean) = waker.wake(seen)

    /** Commands that wait for another port than the one in use do not hold back what that one says. */
    private fun settle() {
        val current = ports.current
        val before = actedThrough.getAndSet(current)
        if (before !== current) commands.forget()
        if (!isSame(before, current)) stale.renew() // what is believed of a port that has come back is as old as it was
        senseAnew()
    }

    /** Whether the agent has one name for both, so that they are one port, which may have been opened again. */
    private fun isSame(before: OpenPort?, current: OpenPort?) = before != null && current != null && before.terms.any { it in current.terms }

    private fun applySensing() {
        val current = ports.current
        if (policy != SensingPolicy.IN_CYCLE) ports.all().forEach { it.sensing.set(isPerceiving && it === current, intervalMs) }
    }

    /** What was sensed so far and has not been perceived is of another time or place. */
    private fun senseAnew() {
        board.forgetHeldBack()
        handOver.clear()
        reflexes.forget()
        applySensing()
    }

    /** What is new since the last call: from the board in use, about the ports, from the Jason environment; null if nothing is. */
    override fun perceive(): MutableCollection<Literal>? {
        waker.perceives()
        val environmentNews = environment.update(super.perceive())
        if (policy == SensingPolicy.IN_CYCLE) ports.current?.takeIf { isPerceiving && it.link.isOpen }?.let { inCycle.sense(it, intervalMs) }
        if (isPerceiving) board.due()?.also(observing::messageFiltered)?.let(handOver::put)
        val snapshot = handOver.take()?.takeIf { isPerceiving && it.port === ports.current }?.let(::current)
        if (snapshot != null) {
            sensed = snapshot.percepts
            observing.messagePerceived(snapshot)
        }
        criticalNews = snapshot?.critical.orEmpty().map { it.percept }
        val staleNews = stale.update()
        listOfNotNull(environment.dueInMs(), board.dueInMs().takeIf { isPerceiving }, stale.dueInMs().takeIf { it != 0L }).minOrNull()?.let(waker::wakeIn)
        if (!environmentNews && snapshot == null && !states.hasNews() && !staleNews) return null
        return (environment.percepts + sensed + states.beliefs() + stale.beliefs()).toMutableList()
    }

    /** [taken] as it is with the filter that is active now. */
    private fun current(taken: Snapshot): Snapshot = board.current(taken).also { if (it !== taken) startReflexes(it) }

    private fun startReflexes(snapshot: Snapshot) {
        snapshot.port?.let { port -> reflexes.perceived(port, snapshot.critical.map { it.rule }) }
    }

    /** Jason calls it when it has added the events of what was perceived. */
    override fun checkMail() {
        if (criticalNews.isNotEmpty()) bringForward(ts.c.events, criticalNews)
        criticalNews = emptyList()
        super.checkMail()
    }

    override fun canSleep(): Boolean =
        super.canSleep() && !handOver.isReady() && !states.hasNews() && !environment.isWaiting() && !stale.hasNews() && !(isPerceiving && board.dueInMs() == 0L)

    override fun reasoningCycleFinished() {
        observing.cycleFinished()
        super.reasoningCycleFinished()
    }

    /** Gives up all ports and threads. Never waits for the line. */
    override fun stop() {
        observing.close()
        if (::ports.isInitialized) ports.stop()
        if (!eachIsStopped) super.stop()
    }

    /** Whether Jason stops each architecture of this agent: its Local infrastructure does, others the first one alone, and not each bears being stopped twice. */
    private val eachIsStopped get() = generateSequence(nextAgArch) { it.nextAgArch }.any { it is LocalAgArch }

    private fun portChanged(port: Term, status: PortStatus, reason: String?) {
        val level = if (status == PortStatus.ON) Level.INFO else Level.WARNING
        observing.portChanged("$port", status.word, reason)
        log.log(level, "port $port is ${status.word}" + reason?.let { ": $it" }.orEmpty())
        waker.wake { !states.hasNews() }
    }

    private inner class Listener : SensingListener {
        override fun request(port: OpenPort) = if (port.link.protocol() == Protocol.V2) board.request else PerceptsRequest.ALL

        override fun received(port: OpenPort, message: String, receivedNanos: Long) {
            if (port !== ports.current || !isPerceiving) return
            stale.renew()
            val snapshot = board.snapshot(port, message, receivedNanos).also(observing::messageFiltered)
            startReflexes(snapshot)
            handOver.put(snapshot)
            ports.report(port, PortStatus.ON)
            waker.wake { !handOver.isReady() && stale.isEmpty() }
        }

        override fun unanswered(port: OpenPort, trouble: PortTimeoutException) =
            ports.report(port, PortStatus.TIMEOUT, trouble.message)

        override fun lost(port: OpenPort, trouble: PortException) = ports.lost(port, trouble)
    }

    internal companion object {
        /** The sensing interval in ms until `argo.limit` sets another. */
        const val DEFAULT_INTERVAL_MS = 50
        private const val NANOS_PER_MS = 1_000_000L
    }
}
