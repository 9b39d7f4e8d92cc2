package argo

import argo.filters.PerceptionFilter
import argo.view.AgentView
import argo.view.ViewedAgent
import argo.view.ViewedPort
import jason.architecture.AgArch
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.bb.BeliefBase
import jason.infra.local.LocalAgArch
import javino.PortException
import javino.PortTimeoutException
import javino.Protocol
import java.util.concurrent.atomic.AtomicBoolean
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
 * over; `argo_percepts=4096`, how many percepts are believed at once; `argo_view=8080`, the port of a live view.
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
    private lateinit var policy: SensingPolicy
    private val commands = CommandLedger()
    private val actedThrough = AtomicReference<OpenPort?>()
    private var observer: AgentObserver = Unobserved
    private val environment = EnvironmentPercepts(nowMs = platform.nowMs)

    @Volatile
    private var perceiving = false

    @Volatile
    private var intervalMs = DEFAULT_INTERVAL_MS
    private var lastInCycle: Long? = null
    private val staleness = Staleness(platform.nowMs)

    @Volatile
    private var sensed: List<Literal> = emptyList()
    private val sightings = Sightings { sensed }

    @Volatile
    private var staleBelieved: Set<Term> = emptySet()
    private lateinit var reflexes: Reflexes
    private var criticalNews: List<Literal> = emptyList()

    /** The agent's live view, if it has one: `argo_view=8080` among its options. There from [init] on. */
    @Volatile
    var view: AgentView? = null
        private set

    override fun init() {
        super.init()
        log = Logger.getLogger("${Arch::class.java.name}.$agName")
        val options = ArchOptions(ts.settings, log)
        policy = options.policy
        waker = Waker(this, platform)
        val rareWarning = { RareWarning(platform.nowMs) { log.warning(it) } }
        board = BoardPercepts(BeliefReader { log.warning(it) }, log, PerceptLimit(options.mostPercepts, rareWarning()), sightings, platform.nowMs)
        reflexes = Reflexes(::sendReflex, rareWarning())
        handOver = if (policy == SensingPolicy.FRESH) FreshHandOver(commands, PerceptEvents(::eventsStand, platform.nowMs) { ts.c.events }) else EveryHandOver { log.warning(it) }
        states = PortStates(::portChanged)
        ports = Ports(agName, states, Listener(), paced = policy != SensingPolicy.IN_CYCLE, platform, ::settle) { log.warning(it) }
        // a view that cannot be had is reported, and the agent does without
        view = options.view?.let { AgentView.open(it, ViewedArch(), log) }?.also { observer = it.observer }
    }

    /** An atomic plan holds back all events; with `events=requeue` those that no plan applies to come back for ever. */
    private fun eventsStand() = ts.c.hasAtomicIntention() || ts.c.atomicEvent != null || ts.settings.requeue()

    /** Perceives through [filter] from the next perception on; null: everything. Called by the agent's thread. */
    internal fun perceiveThrough(filter: PerceptionFilter?) {
        board.switchTo(filter)
        reflexes.forget()
        environment.switchTo(filter)
        observer.filterChanged(filter)
    }

    /** Why the active filter does with [percept] what it does. */
    internal fun explain(percept: Literal): String = board.explain(percept)

    /** The youngest percept belief that unifies with [percept] under [un], and its age in ms; null if there is none. Called by the agent's thread. */
    internal fun youngest(percept: Literal, un: Unifier): Pair<Literal, Long>? {
        val candidates = ts.ag.bb.getCandidateBeliefs(percept, un)?.asSequence().orEmpty()
        return candidates.filter { !it.isRule && it.hasSource(BeliefBase.APercept) && un.clone().unifiesNoUndo(percept, it) }
            .mapNotNull { belief -> sightings.lastSeenNanos(belief)?.let { belief to (platform.clock.nanos() - it) / NANOS_PER_MS } }
            .minByOrNull { (_, ageMs) -> ageMs }
    }

    /** Starts or stops perceiving. */
    internal fun perceive(open: Boolean) {
        if (perceiving == open) return
        perceiving = open
        staleness.renew()
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
        val observed = observer.commandIssued(port.link.port(), text)
        if (policy == SensingPolicy.IN_CYCLE) return outcome(port.commands.write(text, options).also(observed))
        val number = commands.issue()
        port.commands.submit(text, options) {
            commands.done(number)
            observed(it)
            outcome(it)
        }
    }

    /** Sends a reflex, which no snapshot waits for since the agent has not issued it. */
    private fun sendReflex(port: OpenPort, command: String, outcome: (Failure?) -> Unit) {
        val observed = observer.commandIssued(port.link.port(), command)
        if (policy == SensingPolicy.IN_CYCLE) return outcome(port.commands.write(command).also(observed))
        port.commands.submit(command, CommandOptions(urgent = true)) {
            observed(it)
            outcome(it)
        }
    }

    /** Wakes the agent until [seen]: see [Waker]. */
    internal fun wake(seen: () -> Boolean) = waker.wake(seen)

    /** Commands that wait for another port than the one in use do not hold back what that one says. */
    private fun settle() {
        val current = ports.current
        val before = actedThrough.getAndSet(current)
        if (before !== current) commands.forget()
        if (!isSame(before, current)) staleness.renew() // what is believed of a port that has come back is as old as it was
        senseAnew()
    }

    /** Whether the agent has one name for both, so that they are one port, which may have been opened again. */
    private fun isSame(before: OpenPort?, current: OpenPort?) = before != null && current != null && before.terms.any { it in current.terms }

    private fun applySensing() {
        val current = ports.current
        if (policy != SensingPolicy.IN_CYCLE) ports.all().forEach { it.sensing.set(perceiving && it === current, intervalMs) }
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
        if (policy == SensingPolicy.IN_CYCLE) senseInCycle()
        if (perceiving) board.due()?.also(observer::filtered)?.let(handOver::put)
        val snapshot = handOver.take()?.takeIf { perceiving && it.port === ports.current }?.let(::current)
        if (snapshot != null) {
            sensed = snapshot.percepts
            observer.handedOver(snapshot)
        }
        criticalNews = snapshot?.critical.orEmpty().map { it.percept }
        val staleNews = believeStale()
        listOfNotNull(environment.dueInMs(), board.dueInMs().takeIf { perceiving }, staleDueInMs().takeIf { it != 0L }).minOrNull()?.let(waker::wakeIn)
        if (!environmentNews && snapshot == null && !states.hasNews() && !staleNews) return null
        return (environment.percepts + sensed + states.beliefs() + staleBelieved.map { ASSyntax.createLiteral(STALE, it) }).toMutableList()
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

    /** In how many ms the board in use will have been silent for too long; null: it is not listened to, or may be silent. */
    private fun staleDueInMs(): Long? =
        ports.current?.takeIf { perceiving }?.options?.staleAfterMs(intervalMs)?.let(staleness::dueInMs)

    /** The names of the port in use if its board has been silent for too long. */
    private fun stalePorts(): Set<Term> = if (staleDueInMs() == 0L) ports.current?.terms.orEmpty().toSet() else emptySet()

    /** Makes up the agent's mind about [stalePorts], and says whether that is news. */
    private fun believeStale(): Boolean {
        val now = stalePorts()
        return (now != staleBelieved).also { staleBelieved = now }
    }

    private fun senseInCycle() {
        val port = ports.current?.takeIf { perceiving && it.link.isOpen } ?: return
        val start = platform.clock.nanos()
        if (start - (lastInCycle ?: (start - Long.MAX_VALUE / 2)) < intervalMs * NANOS_PER_MS) return
        lastInCycle = start
        port.sensing.exchange()
        waker.wakeIn(intervalMs.toLong()) // an agent that has nothing else to do must perceive again
    }

    override fun canSleep(): Boolean =
        super.canSleep() && !handOver.isReady() && !states.hasNews() && !environment.isWaiting() && stalePorts() == staleBelieved && !(perceiving && board.dueInMs() == 0L)

    override fun reasoningCycleFinished() {
        observer.cycleFinished()
        super.reasoningCycleFinished()
    }

    /** Gives up all ports and threads. Never waits for the line. */
    override fun stop() {
        view?.close()
        if (::ports.isInitialized) ports.stop()
        if (!eachIsStopped) super.stop()
    }

    /** Whether Jason stops each architecture of this agent: its Local infrastructure does, others the first one alone, and not each bears being stopped twice. */
    private val eachIsStopped get() = generateSequence(nextAgArch) { it.nextAgArch }.any { it is LocalAgArch }

    private fun portChanged(port: Term, status: PortStatus, reason: String?) {
        val level = if (status == PortStatus.ON) Level.INFO else Level.WARNING
        observer.portChanged(port, status, reason)
        log.log(level, "port $port is ${status.word}" + reason?.let { ": $it" }.orEmpty())
        waker.wake { !states.hasNews() }
    }

    private inner class Listener : SensingListener {
        override fun request(port: OpenPort) = if (port.link.protocol() == Protocol.V2) board.request else PERCEPTS_REQUEST

        override fun received(port: OpenPort, message: String, receivedNanos: Long) {
            if (port !== ports.current || !perceiving) return
            staleness.renew()
            val snapshot = board.snapshot(port, message, receivedNanos).also(observer::filtered)
            startReflexes(snapshot)
            handOver.put(snapshot)
            ports.report(port, PortStatus.ON)
            waker.wake { !handOver.isReady() && staleBelieved.isEmpty() }
        }

        override fun unanswered(port: OpenPort, trouble: PortTimeoutException) =
            ports.report(port, PortStatus.TIMEOUT, trouble.message)

        override fun lost(port: OpenPort, trouble: PortException) = ports.lost(port, trouble)
    }

    private inner class ViewedArch : ViewedAgent {
        override val name: String = agName
        override val policy get() = this@Arch.policy.word
        override val intervalMs get() = this@Arch.intervalMs
        override val isPerceiving get() = perceiving
        override val beliefs: BeliefBase get() = ts.ag.bb

        override fun nanos() = platform.clock.nanos()

        override fun ports(): List<ViewedPort> {
            val inUse = ports.current?.terms.orEmpty()
            return states.all().map { (port, status) -> ViewedPort("$port", status.word, port in inUse) }
        }

        override fun filterNames() = argo.filterNames(ts.ag)
        override fun filter(name: String) = filterOf(ts.ag, name)
        override fun explain(percept: String) = board.explain(percept)
        override fun perceiveThrough(filter: PerceptionFilter?, done: () -> Unit) = later(done) { this@Arch.perceiveThrough(filter) }
        override fun perceive(open: Boolean, done: () -> Unit) = later(done) { this@Arch.perceive(open) }
        override fun wake() = waker.wake { true }

        /** Has the agent's own thread do [work] before its next cycle. */
        private fun later(done: () -> Unit, work: () -> Unit) {
            val isDone = AtomicBoolean()
            ts.runAtBeginOfNextCycle {
                work()
                isDone.set(true)
                done()
            }
            waker.wake(isDone::get)
        }
    }

    internal companion object {
        /** The functor of the belief that nothing comes from a port. */
        const val STALE = "stale"

        /** The sensing interval in ms until `argo.limit` sets another. */
        const val DEFAULT_INTERVAL_MS = 50
        private const val NANOS_PER_MS = 1_000_000L
    }
}
