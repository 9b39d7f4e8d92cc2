package argo

import argo.acting.CommandLedger
import argo.acting.CommandOptions
import argo.acting.Transmission
import argo.boards.Board
import argo.boards.BoardLine
import argo.boards.OneInstant
import argo.boards.Perceiver
import argo.calls.Failure
import argo.calls.whileLost
import argo.connecting.OpenPort
import argo.connecting.PortOptions
import argo.connecting.PortStates
import argo.connecting.PortStatus
import argo.connecting.PortUser
import argo.connecting.Ports
import argo.connecting.WantedPort
import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import argo.filters.jason.MessageSession
import argo.filters.jason.perceptText
import argo.observing.Observers
import argo.observing.RuleWatcher
import argo.observing.WatchedRule
import argo.perception.EveryHandOver
import argo.perception.FreshHandOver
import argo.perception.HandOver
import argo.perception.PerceptEvents
import argo.perception.PerceptIntentions
import argo.perception.Snapshot
import argo.platform.Platform
import argo.platform.ThinnedLog
import argo.platform.Waker
import argo.platform.nowMs
import argo.sensing.SensingPolicy
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.bb.BeliefBase
import javino.PortException
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicReference
import java.util.logging.Level
import java.util.logging.Logger

/**
 * The boards of one agent: those that it perceives, the hand-over of their snapshots, and the commands to them. [Arch] connects it with
 * Jason.
 *
 * Holds whether the agent perceives, how often, and which boards: one thread at a time writes each of these, and all others read it here
 * without a copy. After each change waiting threads are woken to read again. Functions belong to the agent's thread unless they say
 * otherwise.
 *
 * @property owner the agent's name
 * @param events makes the tracker of one board's percept events in Jason's queue; its argument recognises them
 * @param intentions makes the tracker of the intentions that such events have begun
 * @param observing the agent's observers
 */
internal class AgentIo(
    override val owner: String,
    private val options: ArchOptions,
    override val platform: Platform,
    private val waker: Waker,
    override val log: Logger,
    private val events: (isOwn: (Literal) -> Boolean) -> PerceptEvents,
    private val intentions: (isOwn: (Literal) -> Boolean) -> PerceptIntentions,
    private val observing: () -> Observers,
) : Perceiver {
    /** The boards that the agent perceives, and those that it perceived before and still has beliefs about. Immutable. */
    private class Perceived(val boards: List<Board>, val former: List<Board>)

    /** True if the agent perceives its boards. Any thread may read. */
    @Volatile
    var isPerceiving = false
        private set

    @Volatile
    override var intervalMs = DEFAULT_INTERVAL_MS
        private set

    @Volatile
    override var filter: PerceptionFilter? = null
        private set

    private val coupling = if (options.policy == SensingPolicy.IN_CYCLE) InCycle(platform, waker) else Decoupled
    private val lines = ConcurrentHashMap<OpenPort, BoardLine>()

    /** All boards that were perceived since all ports were last closed; changes while the ports in use change. */
    private val boards = CopyOnWriteArrayList<Board>()
    private val perceived = AtomicReference(Perceived(emptyList(), emptyList()))

    private val instant = OneInstant(platform, waker::wake)
    private val portLines = ThinnedLog(platform.nowMs, platform::later)

    /** True if the agent's beliefs are not yet about the boards that it perceives. */
    @Volatile
    private var isOtherBoards = false

    /** True if a board has, or has had, a namespace of its own. Any thread may read. */
    @Volatile
    var hasNamespaces = false
        private set

    /** The states of the ports. Any thread. */
    val states = PortStates(::portChanged)
    private val ports = Ports(owner, states, User(), coupling.isPaced, platform) { log.warning(it) }

    private var newlyCritical: List<Literal> = emptyList()

    override val maxPercepts get() = options.maxPercepts
    override val leavesRulesToBoards get() = coupling.isPaced

    override fun observers() = observing()

    override val perceivesSeveral get() = perceivedBoards().size > 1

    override fun perceives(board: Board) = isPerceiving && board in perceived.get().boards

    override fun boardOn(port: OpenPort) = if (isPerceiving) perceivedOn(port) else null

    private fun perceivedOn(port: OpenPort) = perceived.get().boards.find { it.port === port }

    override fun handOverOf(board: Board): HandOver =
        if (options.policy == SensingPolicy.FRESH) freshHandOver(board.ledger) { isOf(board, it) } else EveryHandOver { log.warning(it) }

    private fun freshHandOver(ledger: CommandLedger, isOwn: (Literal) -> Boolean) = FreshHandOver(ledger, events(isOwn), intentions(isOwn))

    /** Returns true if [percept] is a percept of [board], or of no board that the agent perceives. */
    private fun isOf(board: Board, percept: Literal): Boolean {
        if (perceivedBoards().size < 2) return true
        val claiming = boardsOf(percept)
        return claiming.isEmpty() || board in claiming
    }

    override fun wake(seen: () -> Boolean) = waker.wake(seen)

    override fun answered(board: Board) = instant.answered(board)

    override fun isForLater(board: Board) = instant.isAwaited(board, perceivedBoards())

    override fun report(port: OpenPort, status: PortStatus, reason: String?) = ports.report(port, status, reason)

    override fun lost(port: OpenPort, trouble: PortException) = ports.lost(port, trouble)

    /** The port in use, or null. Any thread. */
    fun portInUse(): OpenPort? = ports.current

    /** Returns the open port that the agent calls [port], or the one that it waits for; null: there is none. Any thread. */
    fun openPort(port: Term): OpenPort? = (perceivedBoards().map { it.port } + ports.all()).find { port in it.terms }

    /** Returns the perceived boards that have [percept]. */
    fun boardsOf(percept: Literal): List<Board> = perceivedBoards().let { boards ->
        boards.filter { one -> one.claims(percept, boards.none { it !== one && it.namespace == one.namespace }) }
    }

    /** Makes [name] the port in use: see [Ports.choose]. */
    fun choosePort(term: Term, name: String, options: PortOptions?, outcome: (Failure?) -> Unit) =
        ports.choose(term, name, options, outcome)

    /** Makes the ports [wanted] those in use: see [Ports.chooseAll]. */
    fun choosePorts(wanted: List<WantedPort>, outcome: (Failure?) -> Unit) = ports.chooseAll(wanted, outcome)

    /** Closes all ports; [closed] is called by another thread. */
    fun closePorts(closed: () -> Unit) = ports.closeAll(closed)

    /** Returns the board on the port that the agent calls [port], which it perceives or has perceived; null: there is none. Any thread. */
    fun board(port: Term): Board? = boards.find { it.term == port || port in it.port.terms }

    /** Returns the boards that the agent perceives. Any thread. */
    fun perceivedBoards(): List<Board> = perceived.get().boards

    /** Perceives all boards through [filter] from the next perception on; null: everything. */
    fun perceiveThrough(filter: PerceptionFilter?) {
        this.filter = filter
        boards.forEach(Board::perceiveAsOthers)
        renewLines()
    }

    /** Perceives only [board] through [filter] from the next perception on; null: everything. */
    fun perceiveThrough(filter: PerceptionFilter?, board: Board) {
        board.perceiveThrough(filter)
        renewLines()
        observers().boardFilterChanged(board.port.link.port, filter)
    }

    /** Explains why the filters of the boards in its namespace keep or drop [percept]. Any thread. */
    fun explain(percept: Literal): String {
        val named = perceivedBoards().filter { it.namespace != null && it.namespace == percept.ns.functor }
        return if (named.isEmpty()) explain(perceptText(percept), perceivedBoards().filter { it.namespace == null })
        else explain(perceptText(percept.cloneNS(Literal.DefaultNS) as Literal), named)
    }

    /**
     * Explains why the filters of the boards keep or drop the text [percept], and names the side that watches the critical rule that
     * decides. Any thread.
     */
    fun explain(percept: String): String = explain(percept, perceivedBoards())

    private fun explain(percept: String, boards: List<Board>): String {
        val reasons = boards.map { it.term to it.explain(percept) }
        val different = reasons.distinctBy { (_, why) -> why }
        return when (different.size) {
            0 -> explainAlone(percept)
            1 -> different.single().second
            else -> reasons.joinToString("; ") { (port, why) -> "$port: $why" }
        }
    }

    private fun explainAlone(percept: String) =
        MessageSession({ emptyList() }).also { it.switchTo(filter) }.explain(percept, platform.nowMs()).toString()

    /** Returns the critical rules of the active filter, each with the side that watches it. Any thread. */
    fun criticalRules(): List<WatchedRule> = perceivedBoards().flatMap { it.criticalRules() }.distinct()
        .ifEmpty { filter?.critical.orEmpty().map { WatchedRule(it, RuleWatcher.COMPUTER) } }

    override fun isWatchedBy(port: OpenPort, rule: CriticalRule) = lines[port]?.rules?.isWatching(rule) == true

    /** Tells the lines that the agent's wishes to its boards have changed. */
    private fun renewLines() = lines.values.forEach(BoardLine::renew)

    /** Returns the youngest percept in [beliefs] that unifies with [percept] under [un], and its age in ms; null if there is none. */
    fun youngest(beliefs: BeliefBase, percept: Literal, un: Unifier): Pair<Literal, Long>? {
        val now = platform.clock.nanos()
        return believed().mapNotNull { it.youngest(beliefs, percept, un, now) }.minByOrNull { (_, seen) -> now - seen }
            ?.let { (belief, seen) -> belief to TimeUnit.NANOSECONDS.toMillis(now - seen) }
    }

    /** Returns the boards about which the agent has beliefs. */
    private fun believed(): List<Board> = perceived.get().run { boards + former }

    /** Starts or stops perceiving. When it has stopped no further reflex is sent; a board carries its own out until that is removed. */
    fun perceive(open: Boolean) {
        if (isPerceiving == open) return
        isPerceiving = open
        perceived.get().boards.forEach(Board::beginAnew)
        renewLines()
        dueInMs()?.let(waker::wakeIn) // the agent may fall asleep before it perceives
    }

    /** Sets the sensing interval in ms; 0: as fast as the line allows. */
    fun senseEvery(intervalMs: Int) {
        this.intervalMs = intervalMs
        boards.forEach { it.ownIntervalMs = null }
        renewLines()
    }

    /** Sets the sensing interval of only [board]. */
    fun senseEvery(intervalMs: Int, board: Board) {
        board.ownIntervalMs = intervalMs
        renewLines()
    }

    /**
     * Returns the time in ms between the oldest and the newest reading of the boards that the agent believes; null: there is none. Boards
     * that are off, time out or are stale do not count. Any thread.
     */
    fun skewMs(): Long? {
        val readings = perceivedBoards().filter { answers(it.port) }.mapNotNull { it.sensedNanos }
        val first = readings.firstOrNull() ?: return null
        val offsets = readings.map { it - first }
        return TimeUnit.NANOSECONDS.toMillis(offsets.max() - offsets.min())
    }

    override fun answers(port: Any) =
        port is OpenPort && states.statusOf(port.terms) == PortStatus.ON && perceivedOn(port)?.let { port.terms.any(it::isStale) } != true

    override fun send(port: OpenPort, text: String, options: CommandOptions): Transmission {
        val issued = observers().commandIssued(port.link.port, text)
        val commands = lines[port]?.commands
        val transmission = if (commands != null) coupling.send(commands, text, options) else unsent(port)
        if (issued == null) return transmission
        return Transmission { left, outcome ->
            transmission.follow(left) { failure ->
                observers().commandEnded(issued, failure)
                outcome(failure)
            }
        }
    }

    private fun unsent(port: OpenPort) = Transmission { left, outcome ->
        left()
        outcome(Failure("port_gone", "port ${port.link.port} was closed, or its device has gone").whileLost())
    }

    /**
     * Makes the snapshots of a board wait for a command that was [sent][send] on [port].
     *
     * @param cause the percept that made the agent send it: the board of this percept holds the command. If there is none, or no board has
     * it, the command's own board holds it
     * @param outcome as of [Transmission.follow]
     */
    fun hold(transmission: Transmission, port: OpenPort, cause: Literal?, outcome: (Failure?) -> Unit) {
        val causing = cause?.let(::boardsOf).orEmpty()
        val holder = causing.find { it.port === port } ?: causing.firstOrNull() ?: perceivedOn(port)
        val ledger = holder?.ledger ?: return transmission.follow({ }, outcome)
        val number = ledger.issue(port)
        transmission.follow({ ledger.done(port, number) }, outcome)
    }

    /** Takes in all news for the agent since the last call, and returns true if [beliefs] may have changed. */
    fun update(): Boolean {
        val isOther = isOtherBoards
        isOtherBoards = false
        val boards = perceived.get().boards
        coupling.perceiving(intervalMs) { boards.filter { isPerceiving && it.port.link.isOpen }.mapNotNull { lines[it.port]?.sensing } }
        if (isPerceiving) boards.forEach(Board::putDue)
        val snapshots = if (instant.isAwaited(boards)) emptyList() else take(boards)
        if (snapshots.isNotEmpty()) perceived.updateAndGet { Perceived(it.boards, emptyList()) }
        snapshots.forEach { observers().messagePerceived(it) }
        newlyCritical = snapshots.flatMap { snapshot -> snapshot.critical.map { it.percept } }
        val isBoardNews = boards.count(Board::update) > 0 // each is to be updated
        return isOther || snapshots.isNotEmpty() || isBoardNews || states.hasNews()
    }

    private fun take(boards: List<Board>): List<Snapshot> {
        instant.taken()
        return boards.mapNotNull(Board::take)
    }

    /** Returns the new critical percepts of the snapshots that the last [update] handed over; empty when asked again. */
    fun takeNewlyCritical(): List<Literal> = newlyCritical.also { newlyCritical = emptyList() }

    /** Returns the beliefs about the boards, about the ports, and about the outcomes of reflexes. */
    fun beliefs(): List<Literal> =
        believed().flatMap { it.sensed } + states.beliefs() + perceived.get().boards.flatMap(Board::metaBeliefs)

    /** Returns the time in ms until [update] has something to do without news from a board; null: it will not have. */
    fun dueInMs(): Long? = perceivedBoards().mapNotNull(Board::dueInMs).minOrNull()

    /** Returns true if [update] has something to do now. Any thread. */
    fun hasNews(): Boolean = isOtherBoards || states.hasNews() || perceivedBoards().any(Board::hasNews) || hasSnapshots()

    private fun hasSnapshots() = perceivedBoards().let { boards -> boards.any(Board::isReady) && !instant.isAwaited(boards) }

    /** Returns true if the agent believes that [port] is stale. Any thread. */
    fun isStale(port: Term): Boolean = perceived.get().boards.any { it.isStale(port) }

    /** Closes all ports and ends all threads. Never waits for a line. Any thread; may be called twice. */
    fun stop() = ports.stop()

    private fun portChanged(port: Term, status: PortStatus, reason: String?) {
        val level = if (status == PortStatus.ON) Level.INFO else Level.WARNING
        observers().portChanged("$port", status.word, reason)
        portLines.report("$port") { more -> log.log(level, "port $port is ${status.word}" + reason?.let { ": $it" }.orEmpty() + more) }
        waker.wake { !states.hasNews() }
    }

    private inner class User : PortUser {
        override fun use(port: OpenPort): AutoCloseable = BoardLine(port, this@AgentIo) { lines -= port }.also {
            lines[port] = it
            port.link.onBoardEvents(it)
        }

        override fun opened(port: OpenPort) {
            lines[port]?.sensing?.start()
        }

        /** Perceives the boards on the ports in use. Those that were perceived before are disturbed only if their ports are opened anew. */
        override fun portInUseChanged() {
            val before = perceived.get().boards
            val renewed = LinkedHashSet<Board>()
            val now = ports.inUse.map { (term, port) ->
                val board = boardFor(term, port)
                if (board !in before) board.begin(port, isBelieved = board in perceived.get().former)
                if (board !in before || board.port !== port) renewed += board
                board.reconnect(port)
                board
            }.distinct()
            val isKept = before.any(now::contains)
            perceived.updateAndGet { Perceived(now, (if (isKept) it.former else it.former + before) - now.toSet()) }
            (before.filter { it !in now } + renewed).forEach(Board::forget)
            if (ports.inUse.isEmpty()) boards.clear()
            isOtherBoards = true
            renewLines()
            waker.wake { !isOtherBoards }
        }
    }

    private fun boardFor(term: Term, port: OpenPort): Board {
        val known = boards.find { it.port === port } ?: boards.find { it.term == term }
        if (known != null && known.namespace == port.options.namespace) return known
        return Board(term, port, this, known).also {
            if (it.namespace != null) hasNamespaces = true
            boards -= setOfNotNull(known)
            boards += it
            it.renewFilter() // the agent may have changed its own meanwhile
        }
    }

    companion object {
        /** The sensing interval in ms until `argo.limit` sets another. */
        const val DEFAULT_INTERVAL_MS = 50
    }
}
