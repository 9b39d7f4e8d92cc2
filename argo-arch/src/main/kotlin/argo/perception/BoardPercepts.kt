package argo.perception

import argo.acting.Reflexes
import argo.connecting.OpenPort
import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import argo.filters.jason.MessagePerception
import argo.filters.jason.MessageSession
import argo.filters.matching.Explanation
import argo.filters.matching.perceptsOf
import jason.asSyntax.Literal
import javino.LineClock
import javino.PerceptsRequest
import javino.wire.ReflexOutcome
import java.util.logging.Level
import java.util.logging.Logger
import kotlin.concurrent.withLock

/** A board, as its [BoardPercepts] see it. Any thread may call the functions. */
internal interface PerceivedBoard {
    /** The board's percepts that the agent believes. */
    val sensed: List<Literal>

    /** Returns true if the agent perceives the board through [port] now. */
    fun isOn(port: OpenPort): Boolean

    /** Called with each [snapshot] just before its hand-over begins. */
    fun filtered(snapshot: Snapshot)
}

/**
 * Turns each message of [board] into a [Snapshot] for the agent, and passes the snapshot to [handOver].
 *
 * The sensing thread makes a snapshot of each message. The agent's thread makes a snapshot when held-back percepts are due. Both threads
 * make and pass on snapshots under one lock, so no older snapshot follows a newer one. Safe for use by several threads.
 *
 * @param reader reads percepts as literals, which [limit] then limits in number
 * @param handOver receives the snapshots
 * @param reflexes receives the critical rules that each message meets. Sends commands under the lock, so no command follows [forget]
 * @param log logs, at level FINE, the reason why a percept is dropped
 */
internal class BoardPercepts(
    private val board: PerceivedBoard,
    private val reader: BeliefReader,
    limit: PerceptLimit,
    private val handOver: HandOver,
    private val reflexes: Reflexes,
    private val log: Logger,
    private val clock: LineClock,
) {
    private val lock = clock.newLock(false)
    private val session = MessageSession(reader::read, limit::limited)
    private val reports = ReportedPercepts()
    private var message: List<String> = emptyList() // the newest message, without reports
    private var olderNanos: Map<String, Long> = emptyMap() // percepts older than the message, each with the time at which it was true
    private var newest: Snapshot? = null

    /** The times at which the board's percepts were last seen. */
    val lastSeen = PerceptAges { board.sensed }

    /** The active filter's critical rules. */
    @Volatile
    var critical: List<CriticalRule> = emptyList()
        private set

    @Volatile
    private var dueMs: Long? = null

    @Volatile
    var request: String = PerceptsRequest.ALL
        private set

    /** Uses [filter] from now on. If [filter] is null, every percept passes. Makes waiting snapshots again, with the new filter. */
    fun switchTo(filter: PerceptionFilter?) = lock.withLock {
        request = perceptsRequest(filter)
        session.switchTo(filter)
        dueMs = null
        critical = filter?.critical.orEmpty()
        reflexes.keepOnly(critical)
        handOver.drain().forEach {
            val event = it.event?.texts?.joinToString("")
            perceive(it.port, it.texts, it.receivedNanos, isMessage = false, emptySet(), event, it.seenNanos)
        }
    }

    /**
     * Makes a snapshot of [message] and passes it on. The last byte of the message arrived from [port] at [receivedNanos], by the
     * platform's clock. The snapshot also contains percepts that the board has [reported] since [askedNanos], the time of the request.
     *
     * @param seenNanos the percepts older than the message, each with the time at which it was true
     * @param event see [argo.links.BoardMessage.event]
     * @return true if the agent perceives the board on [port]; if false, the message is dropped
     */
    fun received(
        port: OpenPort,
        message: String,
        askedNanos: Long,
        receivedNanos: Long,
        seenNanos: Map<String, Long> = emptyMap(),
        event: String? = null,
    ): Boolean {
        val texts = perceptsOf(message)
        return lock.withLock {
            board.isOn(port).also {
                if (it) {
                    reports.dropBefore(askedNanos)
                    this.message = texts
                    val old = if (session.filter?.smoothing.isNullOrEmpty()) emptySet()
                    else seenNanos.filter { (text, nanos) -> olderNanos[text] == nanos }.keys + reports.texts
                    olderNanos = seenNanos
                    val times = times(reports.texts, seenNanos, receivedNanos)
                    perceive(port, reports.placedIn(texts), receivedNanos, isMessage = true, old, event, times)
                }
            }
        }
    }

    /**
     * Makes and passes on a snapshot of the newest message from [port] with [percept] in it. The board's report of [percept], which meets
     * [rule], arrived at [receivedNanos].
     *
     * @param outcome the outcome of the reflex of [rule]
     * @return true if the agent perceives the board on [port]; if false, the report is dropped
     */
    fun reported(port: OpenPort, rule: CriticalRule, outcome: ReflexOutcome, percept: String, receivedNanos: Long): Boolean {
        val text = perceptsOf(percept).firstOrNull()
        return lock.withLock {
            board.isOn(port).also {
                if (it) {
                    reflexes.reported(rule, outcome)
                    if (text != null) place(port, rule, text, receivedNanos)
                }
            }
        }
    }

    private fun place(port: OpenPort, rule: CriticalRule, text: String, receivedNanos: Long) {
        reports.add(rule, text, receivedNanos)
        val news = reader.read(text).toSet()
        perceive(port, reports.placedIn(message), receivedNanos, isMessage = false, message.toSet(), event = null) {
            if (it in news) receivedNanos else null
        }
    }

    /** Returns [Snapshot.seenNanos] of a message to which the percepts [reported] were added; null if all were seen at [receivedNanos]. */
    private fun times(reported: List<String>, seenNanos: Map<String, Long>, receivedNanos: Long): ((Literal) -> Long?)? {
        if (reported.isEmpty() && seenNanos.isEmpty()) return null
        val older = reported.flatMap(reader::read).toSet()
        val times = seenNanos.flatMap { (text, nanos) -> reader.read(text).map { it to nanos } }.toMap()
        return { if (it in older) null else times[it] ?: receivedNanos }
    }

    /**
     * If held-back percepts are due now, adds them to the newest snapshot and passes it on. If a sensing thread is making a snapshot, does
     * not wait for it, since its snapshot will contain the due percepts.
     */
    fun putDue() {
        if (dueInMs() != 0L || !lock.tryLock()) return
        try {
            val last = newest ?: return
            session.due(nowMs())?.let { leave(last.port, it, last.receivedNanos, last.seenNanos) }
        } finally {
            lock.unlock()
        }
    }

    /** Returns the ms until a held-back percept is due; null if none is held back. */
    fun dueInMs(): Long? = dueMs?.let { maxOf(0, it - nowMs()) }

    /** Forgets waiting snapshots, held-back percepts, readings and met rules. Called when they are outdated or from another board. */
    fun forget() = lock.withLock {
        session.forget()
        newest = null
        message = emptyList()
        olderNanos = emptyMap()
        dueMs = null
        reports.clear()
        handOver.clear()
        reflexes.forget()
    }

    fun explain(percept: String): Explanation = lock.withLock { session.explain(percept, nowMs()) }

    private fun nowMs() = clock.nanos() / 1_000_000

    private fun perceive(
        port: OpenPort?,
        texts: List<String>,
        receivedNanos: Long,
        isMessage: Boolean,
        old: Set<String>,
        event: String?,
        seenNanos: ((Literal) -> Long?)?,
    ) {
        reader.expect(texts.size)
        logDropped(texts)
        val perception = session.perceive(texts, nowMs(), old)
        if (port != null) reflexes.perceived(port, perception.critical.map { it.rule }, isMessage)
        leave(port, perception, receivedNanos, seenNanos, event?.let { eventOf(it, perception.percepts) })
    }

    /** Returns the event for the percept with this [text]; null if the filter has dropped the percept, so [percepts] lacks it. */
    private fun eventOf(text: String, percepts: List<Literal>): PerceptEvent? {
        if (text.isEmpty()) return PerceptEvent(emptyList(), emptyList())
        return reader.read(text).filter(percepts::contains).takeIf { it.isNotEmpty() }?.let { PerceptEvent(listOf(text), it) }
    }

    private fun leave(
        port: OpenPort?,
        perception: MessagePerception,
        receivedNanos: Long,
        seenNanos: ((Literal) -> Long?)?,
        event: PerceptEvent? = null,
    ) {
        val texts = perception.texts
        if (seenNanos == null) lastSeen.seen(perception.seen, perception.percepts, receivedNanos)
        else perception.seen.groupBy(seenNanos).forEach { (at, seen) -> if (at != null) lastSeen.seen(seen, perception.percepts, at) }
        dueMs = texts.nextDueMs
        val snapshot = Snapshot(
            port, texts.received, texts.kept, perception.percepts, receivedNanos, perception.critical, perception.unreadable,
            seenNanos, event,
        )
        newest = snapshot
        board.filtered(snapshot)
        handOver.put(snapshot)
    }

    private fun logDropped(texts: List<String>) {
        if (!log.isLoggable(Level.FINE) || session.filter == null) return
        texts.map { session.explain(it, nowMs()) }.filter { it.outcome != Explanation.Outcome.KEPT }.forEach { log.fine("$it") }
    }
}
