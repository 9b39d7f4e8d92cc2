package argo.boards

import argo.acting.CommandOptions
import argo.acting.Transmission
import argo.acting.ended
import argo.calls.Failure
import argo.calls.whileLost
import argo.connecting.OpenPort
import argo.connecting.PortStates
import argo.connecting.PortStatus
import argo.connecting.PortUser
import argo.connecting.Ports
import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import argo.observing.Observers
import argo.perception.EveryHandOver
import argo.perception.FreshHandOver
import argo.perception.HandOver
import argo.perception.ReasoningQueues
import argo.perception.UnfinishedWork
import argo.platform.Platform
import argo.platform.RateLimitedWarning
import argo.platform.ThinnedLog
import argo.platform.Waker
import argo.platform.nowMs
import argo.sensing.SensingPolicy
import jason.asSyntax.Literal
import jason.asSyntax.Term
import javino.PerceptKind
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.atomic.AtomicReference
import java.util.logging.Level
import java.util.logging.Logger

/**
 * The ports of one agent, the boards on them, and the agent's wishes. A wish says whether the agent perceives the boards, how often, or
 * through which filter.
 *
 * One thread at a time changes a wish. Other threads read it here and keep no copy. After a change, waiting threads are woken and read the
 * wishes again. Any thread may call a function if its comment names no thread.
 *
 * @property maxPercepts the largest number of percepts of one board that the agent believes at once
 * @param queues the agent's events and intentions
 */
internal class AgentBoards(
    val owner: String,
    private val policy: SensingPolicy,
    val maxPercepts: Int,
    val platform: Platform,
    private val waker: Waker,
    val log: Logger,
    private val queues: ReasoningQueues,
    private val observing: () -> Observers,
) {
    /** The boards that the agent perceives, and former boards about which it still has beliefs. Immutable. */
    private class Perceived(val boards: List<Board>, val former: List<Board>)

    @Volatile
    var isPerceiving = false
        private set

    /** The sensing interval in ms of all boards that have no interval of their own. */
    @Volatile
    var intervalMs = DEFAULT_INTERVAL_MS
        private set

    /** The filter of all boards that have no filter of their own; null if every percept passes. */
    @Volatile
    var filter: PerceptionFilter? = null
        private set

    /** Senses and sends on the agent's thread, as the published ARGO does; null if separate threads sense and send. */
    private val inCycle = if (policy == SensingPolicy.IN_CYCLE) InCycle(platform, waker) else null
    private val lines = ConcurrentHashMap<OpenPort, BoardLine>()

    /** All boards that the agent has perceived since it last closed its ports. Changes only with the ports in use. */
    private val boards = CopyOnWriteArrayList<Board>()
    private val perceived = AtomicReference(Perceived(emptyList(), emptyList()))
    private val portLines = ThinnedLog(platform.nowMs, platform::later)

    /** True from a change of the perceived boards until the agent's next perception. */
    @Volatile
    var areOthers = false
        private set

    /** True while the agent is paused, see [argo.observing.Pausing]. */
    @Volatile
    private var isStanding = false

    val states = PortStates(::portChanged)

    val ports = Ports(owner, states, User(), leavesRulesToBoards, platform) { log.warning(it) }

    val ready = SimultaneousSnapshots(platform, { perceived.get().boards }, waker::wake)

    /** True if boards watch those critical rules that they can watch, and messages are written at the pace of the line. */
    val leavesRulesToBoards get() = inCycle == null

    val observers: Observers get() = observing()

    val current: List<Board> get() = perceived.get().boards

    /** The boards about which the agent has beliefs. */
    val believed: List<Board> get() = perceived.get().run { boards + former }

    val areSeveral get() = current.size > 1

    fun perceives(board: Board) = isPerceiving && board in current

    fun boardOn(port: OpenPort): Board? = if (isPerceiving) inUseOn(port) else null

    fun inUseOn(port: OpenPort): Board? = current.find { it.port === port }

    /** Returns the board that the agent calls [port], even if the agent no longer perceives it; null if no board has this name. */
    fun named(port: Term): Board? = boards.find { it.term == port || port in it.port.terms }

    /** Returns the perceived boards that may have sent [percept]. */
    fun of(percept: Literal): List<Board> = current.filter { it.isNamed(percept) }.let { named ->
        if (named.size == 1) named else named.filter { it.hadOrHas(percept) }
    }

    /** Returns the open port, or the perceived board's port, that the agent calls [port]; null if there is none. */
    fun openPort(port: Term): OpenPort? = (current.map { it.port } + ports.all()).find { port in it.terms }

    /** Returns true if the board on [port], an [OpenPort], answers. The state of its port is on and not stale. */
    fun answers(port: Any): Boolean =
        port is OpenPort && states.statusOf(port.terms) == PortStatus.ON && inUseOn(port)?.let { port.terms.any(it::isStale) } != true

    /** Returns the kinds of percepts that the board on [portName] describes, see [DescribedPercepts.get]. */
    fun perceptKinds(portName: String): List<PerceptKind> =
        lines.entries.find { it.key.link.port == portName }?.value?.described?.get().orEmpty()

    fun isWatchedBy(port: OpenPort, rule: CriticalRule): Boolean = lines[port]?.rules?.isWatching(rule) == true

    fun handOverOf(board: Board): HandOver {
        if (policy != SensingPolicy.FRESH) {
            return EveryHandOver({ policy == SensingPolicy.EVERY && queues.areCrowded() }) { log.warning(it) }
        }
        val late = rateLimitedWarning()
        val tellLost = { count: Long ->
            if (count.countOneBits() == 1) {
                log.warning("the agent is too slow for the events of port ${board.term}: $count are lost; make its plans for them shorter")
            }
        }
        return FreshHandOver(UnfinishedWork(board.ledger, queues, platform.nowMs) { isOf(board, it) }, tellLost) { ms, why ->
            if (!isStanding) late.report("late") {
                "the newest percepts of port ${board.term} have not reached the agent for $ms ms: $why. " +
                    "Commands with timeout(Ms) or latest do not pile up"
            }
        }
    }

    /** Returns true if [percept] belongs to [board], or if it is in the namespace of [board] and belongs to no perceived board. */
    private fun isOf(board: Board, percept: Literal): Boolean {
        if (!areSeveral) return true
        if (!board.isNamed(percept)) return false
        val claiming = of(percept)
        return claiming.isEmpty() || board in claiming
    }

    /** Returns a new warning for the agent's log. The warning is not repeated while its cause lasts. */
    fun rateLimitedWarning() = RateLimitedWarning(platform.nowMs) { log.warning(it) }

    fun wake(seen: () -> Boolean) = waker.wake(seen)

    /** Starts or stops perceiving. After a stop the computer sends no reflexes. A board carries out its own until its rules are removed. */
    fun perceive(open: Boolean) {
        if (isPerceiving == open) return
        isPerceiving = open
        current.forEach(Board::beginAnew)
        renewLines()
        dueInMs()?.let(waker::wakeIn) // the agent may fall asleep before its next perception
    }

    /** Sets the sensing interval of [board] in ms. If [board] is null, sets it for all boards. 0 means as fast as the line allows. */
    fun senseEvery(intervalMs: Int, board: Board? = null) {
        if (board != null) {
            board.ownIntervalMs = intervalMs
        } else {
            this.intervalMs = intervalMs
            boards.forEach { it.ownIntervalMs = null }
        }
        renewLines()
    }

    /**
     * Uses [filter] for all boards from the next perception on. If [filter] is null, every percept passes. Called by the agent's thread.
     */
    fun perceiveThrough(filter: PerceptionFilter?) {
        this.filter = filter
        boards.forEach(Board::perceiveAsOthers)
        renewLines()
    }

    /**
     * Uses [filter] only for [board], from the next perception on. If [filter] is null, every percept passes. Called by the agent's thread.
     */
    fun perceiveThrough(filter: PerceptionFilter?, board: Board) {
        board.perceiveThrough(filter)
        renewLines()
        observers.each { it.boardFilterChanged(board.port.link.port, filter) }
    }

    private fun renewLines() = lines.values.forEach(BoardLine::renew)

    /** Begins a perception of the agent, on its thread. Returns true if the perceived boards may have changed since the last perception. */
    fun perceiving(): Boolean {
        val wereOthers = areOthers
        areOthers = false
        inCycle?.perceiving(intervalMs) { current.filter { isPerceiving && it.port.link.isOpen }.mapNotNull { lines[it.port]?.sensing } }
        return wereOthers
    }

    fun forgetFormer() {
        perceived.updateAndGet { Perceived(it.boards, emptyList()) }
    }

    /** Returns in how many ms the agent has something to perceive, even if no board sends news; null if nothing becomes due. */
    fun dueInMs(): Long? = current.mapNotNull(Board::dueInMs).minOrNull()

    /** Sends [text] on [port]. No snapshot waits for this command. Call [follow][Transmission.follow] on the result. */
    fun send(port: OpenPort, text: String, options: CommandOptions): Transmission {
        val issued = observers.commandIssued(port.link.port, text)
        val commands = lines[port]?.commands
        val transmission = when {
            commands == null ->
                ended(Failure("port_gone", "port ${port.link.port} was closed, or its device has gone").whileLost())
            inCycle != null -> commands.sendNow(text, options)
            else -> commands.send(text, options)
        }
        if (issued == null) return transmission
        return Transmission(transmission.giveUp) { left, outcome ->
            transmission.follow(left) { failure, answer ->
                observers.each { it.commandEnded(issued, failure) }
                outcome(failure, answer)
            }
        }
    }

    /**
     * Notes that a pause of the agent begins or ends. After a pause, the agent perceives only the newest snapshot of each board. Called by
     * the agent's thread.
     */
    fun stands(isStanding: Boolean) {
        this.isStanding = isStanding
        val dropped = if (isStanding) 0 else current.sumOf(Board::catchUp)
        if (dropped > 0) log.info("$dropped snapshots that came while the agent was paused are left out, and it perceives the newest")
    }

    private fun portChanged(port: Term, status: PortStatus, reason: String?) {
        val level = if (status == PortStatus.ON) Level.INFO else Level.WARNING
        observers.each { it.portChanged("$port", status.word, reason) }
        waker.wake { !states.hasNews() } // before the line, since many agents wait for one log
        portLines.report("$port") { more -> log.log(level, "port $port is ${status.word}" + reason?.let { ": $it" }.orEmpty() + more) }
    }

    private inner class User : PortUser {
        override fun use(port: OpenPort): AutoCloseable = BoardLine(port, this@AgentBoards) { lines -= port }.also {
            lines[port] = it
            port.link.onBoardEvents(it)
        }

        override fun opened(port: OpenPort) {
            lines[port]?.sensing?.start()
        }

        /** Perceives the boards on the ports in use. A board that was perceived before is disturbed only if its port was opened again. */
        override fun portInUseChanged() {
            val before = current
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
            areOthers = true
            renewLines()
            waker.wake { !areOthers }
        }
    }

    private fun boardFor(term: Term, port: OpenPort): Board {
        val known = boards.find { it.port === port } ?: boards.find { it.term == term }
        if (known != null && known.namespace == port.options.namespace) return known
        return Board(term, port, this, known).also {
            boards -= setOfNotNull(known)
            boards += it
            it.renewFilter() // the agent may have changed its filter while it did not perceive the board
        }
    }

    companion object {
        /** The sensing interval in ms, until `argo.limit` sets another one. */
        const val DEFAULT_INTERVAL_MS = 50
    }
}
