package argo.boards

import argo.acting.CommandLedger
import argo.acting.CommandOptions
import argo.acting.Reflexes
import argo.calls.Failure
import argo.connecting.OpenPort
import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import argo.links.BoardMessage
import argo.observing.RuleWatcher
import argo.observing.WatchedRule
import argo.perception.BeliefReader
import argo.perception.BoardPercepts
import argo.perception.HandOver
import argo.perception.PerceivedBoard
import argo.perception.PerceptLimit
import argo.perception.Snapshot
import argo.platform.nowMs
import argo.sensing.StaleBeliefs
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Atom
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.bb.BeliefBase
import javino.wire.BoardAction
import javino.wire.BoardAction.ANY
import javino.wire.ReflexOutcome
import java.util.concurrent.atomic.AtomicReference
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * A board that an agent perceives or has perceived: the beliefs about it, its snapshots, its filter and its interval. All of these stay
 * when the device vanishes and returns. A function without the note "Any thread" is for the agent's thread only.
 *
 * @property term the agent's name for the port
 * @param port the line to the board
 * @param former the board that leaves its own filter and interval to this board; null if the agent's filter and interval apply
 */
internal class Board(val term: Term, port: OpenPort, private val agent: AgentBoards, former: Board? = null) : PerceivedBoard {
    /** The board's own filter. If [filter] is null, every percept passes. */
    private class OwnFilter(val filter: PerceptionFilter?)

    /** The namespace of the board's percepts; null for the default namespace. */
    val namespace: String? = port.options.namespace
    private val space: Atom? = namespace?.let(ASSyntax::createAtom)

    /** The port of the board. While the device is missing, this is a closed port. Any thread may read it. */
    @Volatile
    var port: OpenPort = port
        private set

    private val believed = AtomicReference(BelievedPercepts.NONE)

    /** The board's percepts that the agent believes. Any thread may read them. */
    override val sensed: List<Literal> get() = believed.get().percepts

    /** The time at which the percepts in [sensed] arrived, by the platform's clock; null if there are none. Any thread may read it. */
    val sensedNanos: Long? get() = believed.get().nanos

    /** The board's own sensing interval in ms; null if the agent's interval applies. Any thread. */
    @Volatile
    var ownIntervalMs: Int? = former?.ownIntervalMs

    /** The sensing interval in ms. Any thread may read it. */
    val intervalMs: Int get() = ownIntervalMs ?: agent.intervalMs

    @Volatile
    private var ownFilter: OwnFilter? = former?.ownFilter

    /** True if a filter, or `none`, was chosen for this board only. Any thread may read it. */
    val hasOwnFilter: Boolean get() = ownFilter != null

    /** The filter that applies to the board; null if every percept passes. Any thread may read it. */
    val filter: PerceptionFilter? get() = ownFilter.let { if (it == null) agent.filter else it.filter }

    val answer = ExpectedAnswer()

    /** The commands for which the board's snapshots wait. */
    val ledger = CommandLedger(agent.platform.nowMs, agent::answers) { this.port }
    private val handOver: HandOver = agent.handOverOf(this)
    private val choosing = ReentrantLock() // held from the choice of a filter until its use
    private val stale = StaleBeliefs(agent.platform.nowMs, { this.port.takeIf { agent.perceives(this) } }, ::intervalMs)
    private val reflexes = Reflexes(::sendReflex, agent::isWatchedBy, ::reflexEnded, agent.rateLimitedWarning())
    private val percepts = BoardPercepts(
        this, BeliefReader(space) { agent.log.warning(it) }, PerceptLimit(agent.maxPercepts, agent.rateLimitedWarning()),
        handOver, reflexes, agent.log, agent.platform.clock,
    )

    /**
     * The actions that the board has registered; null if unknown. If several have one name, only the last of them is included. Any thread.
     */
    val actions: List<BoardAction>?
        get() = port.link.actions?.takeIf { it.isNotEmpty() }?.associateBy { it.name }?.values?.toList()

    /** Returns true if the board has registered an action with the name and the number of arguments of [command]. Any thread. */
    fun knows(command: Literal): Boolean =
        actions.orEmpty().any { it.name == command.functor && (it.arguments == ANY || it.arguments == command.arity) }

    val critical: List<CriticalRule> get() = percepts.critical

    /** The request to a board of version 2 of the protocol. Any thread. */
    val request: String get() = percepts.request

    override fun isOn(port: OpenPort) = port === this.port && agent.perceives(this)

    override fun filtered(snapshot: Snapshot) = agent.observers.each { it.messageFiltered(snapshot) }

    /** Prepares the board to be perceived through [port]. Called by any thread, before the board is perceived. */
    fun begin(port: OpenPort, isBelieved: Boolean) {
        this.port = port
        if (!isBelieved) believed.updateAndGet { it.then(emptyList(), null) }
        stale.renew()
    }

    /** Uses [port] from now on, since the device has returned. Beliefs about the board keep their age. Any thread. */
    fun reconnect(port: OpenPort) {
        this.port = port
    }

    /** Forgets percepts that the agent has not perceived yet. Called when these percepts are outdated or from another board. Any thread. */
    fun forget() = percepts.forget()

    /**
     * Forgets percepts that the agent has not perceived yet, and restarts the time until the board is stale. Called when perceiving begins
     * or stops.
     */
    fun beginAnew() {
        stale.renew()
        forget()
    }

    fun perceiveThrough(filter: PerceptionFilter?) {
        ownFilter = OwnFilter(filter)
        renewFilter()
    }

    fun perceiveAsOthers() {
        ownFilter = null
        renewFilter()
    }

    /** Applies the board's changed filter from the next perception on. Any thread. */
    fun renewFilter() = choosing.withLock { percepts.switchTo(filter) }

    /**
     * Explains why the filter keeps or drops [percept]. If a critical rule decides, says whether computer or board watches it. Any thread.
     */
    fun explain(percept: String): String {
        val explanation = percepts.explain(percept)
        val critical = criticalRules().find { it.rule.rule === explanation.rule } ?: return "$explanation"
        return "$explanation; ${critical.watcher.word} watches it"
    }

    /** Returns the critical rules of the filter, each with its watcher, which is the computer or the board. Any thread. */
    fun criticalRules(): List<WatchedRule> =
        critical.map { WatchedRule(it, if (agent.isWatchedBy(port, it)) RuleWatcher.BOARD else RuleWatcher.COMPUTER) }

    /** Returns the youngest percept in [beliefs] that unifies with [percept] under [un], and its time; null if none unifies. */
    fun youngest(beliefs: BeliefBase, percept: Literal, un: Unifier, nowNanos: Long): Pair<Literal, Long>? =
        percepts.lastSeen.youngest(beliefs, percept, un, nowNanos)

    /**
     * Handles a message, see [BoardPercepts.received]. The next request to the board goes out at [nextNanos]. Called by the sensing thread
     * of [port].
     */
    fun received(port: OpenPort, message: BoardMessage, askedNanos: Long, nextNanos: Long) {
        answer.came(message.receivedNanos)
        val isWanted = percepts.received(port, message.text, askedNanos, message.receivedNanos, message.seenNanos, message.event)
        answer.read(nextNanos)
        agent.ready.answered(this)
        if (!isWanted) return
        stale.renew()
        if (isForLater()) return
        agent.wake { !handOver.isReady() && stale.isEmpty() }
    }

    /** Returns true if the new snapshot waits for other boards' answers. The last of these answers wakes the agent. */
    private fun isForLater() = handOver.isReady() && !hasNews() && agent.ready.isAwaiting(this)

    /** Handles a percept that the board has reported. For the parameters and the result see [BoardPercepts.reported]. Any thread. */
    fun reported(port: OpenPort, rule: CriticalRule, outcome: ReflexOutcome, percept: String, receivedNanos: Long): Boolean =
        percepts.reported(port, rule, outcome, percept, receivedNanos).also { if (it) agent.wake { !handOver.isReady() } }

    /** Makes a snapshot of the held-back percepts that are due. */
    fun putDue() = percepts.putDue()

    fun isReady(): Boolean = handOver.isReady()

    /** Returns true if a snapshot is ready and must not wait for other boards. Any thread. */
    fun isUrgent(): Boolean = handOver.isUrgent()

    /** Makes the newest snapshot the next one to be perceived, see [HandOver.catchUp]. */
    fun catchUp(): Int = handOver.catchUp()

    fun take(): Snapshot? = handOver.take()?.takeIf { it.port == null || isOn(it.port) }?.also { taken ->
        believed.updateAndGet { it.then(taken.percepts, taken.receivedNanos) }
    }

    fun isNamed(percept: Literal): Boolean = percept.ns == (space ?: Literal.DefaultNS)

    fun hadOrHas(percept: Literal): Boolean = percept in believed.get()

    /** Recomputes whether the board is stale. Returns true if this has changed, or if a reflex has an outcome. */
    fun update(): Boolean = stale.update() || reflexes.hasNews()

    fun metaBeliefs(): List<Literal> = stale.beliefs() + reflexes.beliefs().map { if (space == null) it else it.cloneNS(space) as Literal }

    /** Returns after how many ms the agent must perceive this board even without a message; null if nothing becomes due. */
    fun dueInMs(): Long? {
        val heldBack = percepts.dueInMs().takeIf { agent.perceives(this) }
        return listOfNotNull(heldBack, stale.dueInMs().takeIf { it != 0L }, handOver.dueInMs()).minOrNull()
    }

    /** Returns true if the agent has something to perceive of this board now, besides snapshots. Any thread. */
    fun hasNews(): Boolean = stale.hasNews() || reflexes.hasNews() ||
        agent.perceives(this) && percepts.dueInMs() == 0L

    fun isStale(port: Term): Boolean = stale.isStale(port)

    private fun sendReflex(port: OpenPort, command: String, outcome: (Failure?) -> Unit) =
        agent.send(port, command, CommandOptions(urgent = true)).follow({ }) { failure, _ -> outcome(failure) }

    private fun reflexEnded(rule: CriticalRule, watcher: RuleWatcher, failure: Failure?) {
        agent.observers.reflexEnded(rule, watcher, failure)
        agent.wake { !reflexes.hasNews() }
    }
}
