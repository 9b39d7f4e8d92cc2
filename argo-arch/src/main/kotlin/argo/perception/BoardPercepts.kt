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

/** The board in the view of its percepts. Any thread may call. */
internal interface PerceivedBoard {
    /** The board's percepts that the agent believes. */
    val sensed: List<Literal>

    /** Returns true if the agent perceives the board through [port] now. */
    fun isOn(port: OpenPort): Boolean

    /** Takes each [snapshot] that is ready for the agent. */
    fun filtered(snapshot: Snapshot)
}

/**
 * Turns each message of a [board] into a [Snapshot] for its agent, and passes it to the hand-over.
 *
 * The sensing thread makes snapshots from messages, and the agent's thread from held-back percepts. Both make snapshots and pass them on
 * under one lock, so no older snapshot follows a newer one. Safe for use by several threads.
 *
 * @param reader reads the beliefs; [limit] selects from them
 * @param handOver takes the snapshots
 * @param reflexes takes the critical rules that each message meets; commands are submitted under the lock, so no command follows [forget]
 * @param log takes, at level FINE, the reason why a percept is dropped
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
    private var olderNanos: Map<String, Long> = emptyMap() // by percept older than the message, the time at which it was true
    private var newest: Snapshot? = null

    /** The times at which the board's percepts were last seen. */
    val lastSeen = LastSeen { board.sensed }

    /** The active filter's critical rules. */
    @Volatile
    var critical: List<CriticalRule> = emptyList()
        private set

    @Volatile
    private var dueMs: Long? = null

    @Volatile
    var request: String = PerceptsRequest.ALL
        private set

    /** Perceives through [filter] from now on; null: everything. Makes pending snapshots anew. */
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
     * Makes and passes on the snapshot of a [message] from [port] with its last byte at [receivedNanos], by the platform's clock. Keeps the
     * percepts that the board has [reported] since [askedNanos], the time of the request for the message.
     * @param seenNanos the times at which percepts older than the message were true
     * @param event see [argo.links.BoardMessage.event]
     * @return true if the message was wanted
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
     * Makes the newest message from [port], with [percept] in it, into a snapshot, and passes this on. The board has reported [percept] at
     * [receivedNanos] because it meets [rule].
     *
     * @param outcome the outcome of the rule's reflex
     * @return true if the report was wanted
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

    /** Returns the times at which the percepts of a message with [reported] ones were seen; null: all were seen at [receivedNanos]. */
    private fun times(reported: List<String>, seenNanos: Map<String, Long>, receivedNanos: Long): ((Literal) -> Long?)? {
        if (reported.isEmpty() && seenNanos.isEmpty()) return null
        val older = reported.flatMap(reader::read).toSet()
        val times = seenNanos.flatMap { (text, nanos) -> reader.read(text).map { it to nanos } }.toMap()
        return { if (it in older) null else times[it] ?: receivedNanos }
    }

    /**
     * Makes the newest snapshot with the held-back percepts that are due now, if any, and passes it on. Does not wait for a sensing thread
     * that is making a snapshot: the due percepts go into that snapshot.
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

    /** Returns the ms until a held-back percept is due; null: none is held back. */
    fun dueInMs(): Long? = dueMs?.let { maxOf(0, it - nowMs()) }

    /** Forgets pending snapshots, held-back percepts, readings and met rules, since they are of another time or another board. */
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

    /** Returns the event [text] in the form that it has among [percepts]; null: the filter drops it. */
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
