package argo.perception

import argo.filters.PerceptionFilter
import argo.filters.jason.MessagePerception
import argo.filters.jason.MessageSession
import argo.filters.jason.perceptText
import argo.filters.matching.Explanation
import argo.filters.matching.perceptsOf
import argo.ports.OpenPort
import jason.asSyntax.Literal
import java.util.concurrent.locks.ReentrantLock
import java.util.logging.Level
import java.util.logging.Logger
import javino.PerceptsRequest
import kotlin.concurrent.withLock

/**
 * Turns what a board says into what its agent perceives: through the active filter, and what that keeps through [reader].
 *
 * Safe for use by several threads: the sensing thread does the work, so that the agent's has little left to do.
 *
 * @param log is told at level FINE why a percept is dropped
 * @param limit on the percepts of one message
 * @param sightings is told what stood in each message
 * @param nowMs a clock in ms that never goes back
 */
internal class BoardPercepts(
    private val reader: BeliefReader,
    private val log: Logger,
    private val limit: PerceptLimit,
    private val sightings: LastSeen,
    private val nowMs: () -> Long,
) {
    private val lock = ReentrantLock()
    private val session = MessageSession(reader::read, limit::limited)
    private var filterVersion = 0L
    private var newest: Snapshot? = null

    @Volatile
    private var dueMs: Long? = null

    /** What a board of version 2 is to be asked, see [perceptsRequest]. */
    @Volatile
    var request: String = PerceptsRequest.ALL
        private set

    /** Perceives through [filter] from now on; null: everything. */
    fun switchTo(filter: PerceptionFilter?) = lock.withLock {
        request = perceptsRequest(filter)
        session.switchTo(filter)
        dueMs = null
        filterVersion++
    }

    /** What the agent perceives of a [message] of the board on [port], whose last byte came at [receivedNanos] by the platform's clock. */
    fun snapshot(port: OpenPort?, message: String, receivedNanos: Long): Snapshot {
        val texts = perceptsOf(message)
        return lock.withLock {
            reader.expect(texts.size)
            snapshot(port, texts, receivedNanos)
        }
    }

    /** [snapshot] as it is with the filter that is active now. */
    fun current(snapshot: Snapshot): Snapshot = lock.withLock {
        if (snapshot.filterVersion == filterVersion) snapshot else snapshot(snapshot.port, snapshot.texts, snapshot.receivedNanos)
    }

    private fun snapshot(port: OpenPort?, texts: List<String>, receivedNanos: Long): Snapshot {
        explainTo(log, texts)
        return remember(port, session.perceive(texts, nowMs()), receivedNanos)
    }

    private fun explainTo(log: Logger, texts: List<String>) {
        if (!log.isLoggable(Level.FINE) || session.filter == null) return
        texts.map { session.explain(it, nowMs()) }.filter { it.outcome != Explanation.Outcome.KEPT }.forEach { log.fine("$it") }
    }

    /** In how many ms a percept that the filter holds back is due; null if none is held back. */
    fun dueInMs(): Long? = dueMs?.let { maxOf(0, it - nowMs()) }

    /** The newest snapshot with the held-back percepts that are due now; null if none is, or a message is being read anyway. */
    fun due(): Snapshot? {
        if (dueInMs() != 0L || !lock.tryLock()) return null
        try {
            val last = newest ?: return null
            val due = session.due(nowMs()) ?: return null
            return remember(last.port, due, last.receivedNanos)
        } finally {
            lock.unlock()
        }
    }

    /** The sensors are not looked at for a while: what is held back now will be too old when they are again. */
    fun forgetHeldBack() = lock.withLock {
        newest = null
        dueMs = null
    }

    private fun remember(port: OpenPort?, of: MessagePerception, receivedNanos: Long): Snapshot {
        sightings.seen(of.seen, of.percepts, receivedNanos)
        dueMs = of.texts.nextDueMs
        return Snapshot(port, of.texts.received, of.texts.kept, filterVersion, of.percepts, receivedNanos, of.critical, of.unreadable).also { newest = it }
    }

    /** Why the active filter does with [percept] what it does. */
    fun explain(percept: Literal): String = explain(perceptText(percept))

    /** Why the active filter does with the text [percept] what it does. */
    fun explain(percept: String): String = lock.withLock { session.explain(percept, nowMs()).toString() }
}
