package argo.perception

import argo.acting.CommandLedger
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Passes snapshots from the sensing thread to the reasoning cycle; neither waits for the other.
 *
 * [take] belongs to the agent's thread and is called in each of its perceptions; the others may be called by any.
 */
internal interface HandOver {
    /** Leaves [snapshot] for the agent; it may be left out if there is already one of a newer message. */
    fun put(snapshot: Snapshot)

    /** Returns true if [take] would give one now. */
    fun isReady(): Boolean

    /** Returns true if the snapshot that [take] would give now waits for nothing else. */
    fun isUrgent(): Boolean = isReady()

    /** Returns the time in ms until a snapshot may become ready without any news; null: none will. */
    fun dueInMs(): Long? = null

    /** Takes the snapshot to perceive now; null: none is ready. */
    fun take(): Snapshot?

    /** Takes all snapshots out, in the order of their messages. */
    fun drain(): List<Snapshot>

    /** Forgets the snapshots that have not been taken, and the critical percepts of those that have. */
    fun clear()
}

/**
 * Keeps the newest snapshot only and hands it over when
 * 1. the percept events of the one before have been taken from Jason's event queue,
 * 2. every command that was issued before the hand-over of the one before has gone out, failed or timed out, and
 * 3. the intentions that percept events have begun are worked off.
 *
 * Without (1) events pile up, since Jason handles one a cycle; without (2) commands do, since the line is slower than the
 * agent; without (3) intentions do, since Jason runs one step a cycle. Waiting for all commands would starve the sensing of a plan that
 * loops on `argo.act`.
 *
 * A snapshot with a critical percept that the one before did not have is handed over at once, and a newer one replaces it only if it meets
 * the same critical rules. A board that is critical all the time must not make events pile up, so this ends when [MANY_EVENTS] wait; then
 * each critical rule may do it once until all three conditions hold again.
 */
internal class FreshHandOver(
    private val commands: CommandLedger,
    private val events: PerceptEvents,
    private val intentions: PerceptIntentions = PerceptIntentions(),
) : HandOver {
    private val lock = ReentrantLock() // one for both, or an older snapshot of the one could be taken after a newer one of the other
    private val critical = CriticalSnapshots()

    @Volatile
    private var newest: Snapshot? = null

    @Volatile
    private var commandsToAwait = 0L

    override fun put(snapshot: Snapshot) = lock.withLock {
        val newer = newest?.takeIf { it.receivedNanos - snapshot.receivedNanos > 0 }
        newest = if (critical.put(snapshot)) newer else newer ?: snapshot
    }

    override fun isReady(): Boolean = isReady(::isTakenIn)

    private inline fun isReady(isTakenIn: () -> Boolean): Boolean {
        val urgent = critical.first()
        return if (urgent == null) newest != null && isTakenIn() else mayBeEarly(urgent) || isTakenIn()
    }

    override fun isUrgent(): Boolean = critical.first() != null && isReady()

    override fun dueInMs(): Long? = if (newest == null) null else commands.dueInMs(commandsToAwait)

    /** Returns true if the agent has taken in the snapshot before. */
    private fun isTakenIn() = areEventsAndCommandsDone() && !intentions.wait()

    private fun areEventsAndCommandsDone() = commands.allDoneUpTo(commandsToAwait) && !events.wait()

    private fun mayBeEarly(snapshot: Snapshot) = events.waiting() < MANY_EVENTS || critical.mayBeEarly(snapshot)

    override fun take(): Snapshot? {
        events.takenIn()
        if (newest == null && critical.first() == null) return null
        val areOthersDone = areEventsAndCommandsDone()
        if (areOthersDone) intentions.await()
        val isTakenIn = areOthersDone && !intentions.wait()
        if (!isReady { isTakenIn }) return null
        val snapshot = lock.withLock { critical.take(isTakenIn) ?: takeInTurn(isTakenIn) } ?: return null
        commandsToAwait = commands.lastIssued()
        events.handedOver()
        intentions.handedOver()
        return snapshot
    }

    private fun takeInTurn(isTakenIn: Boolean): Snapshot? = if (isTakenIn) takeNewest()?.also(critical::tookOther) else null

    private fun takeNewest(): Snapshot? = newest.also { newest = null }

    override fun drain() = lock.withLock { critical.drain() + listOfNotNull(takeNewest()) }.sortedBy { it.receivedNanos }

    override fun clear() = lock.withLock {
        critical.clear()
        newest = null
    }

    companion object {
        /** While fewer events than this wait, a critical snapshot is handed over at once. */
        const val MANY_EVENTS = 1000
    }
}

/** Hands over every snapshot in its order; an agent that is [MAX_WAITING] behind loses the oldest, with one warning. */
internal class EveryHandOver(private val warn: (String) -> Unit) : HandOver {
    private val waiting = ConcurrentLinkedQueue<Snapshot>()
    private val count = AtomicInteger()
    private var warned = false

    override fun put(snapshot: Snapshot) {
        waiting.add(snapshot)
        if (count.incrementAndGet() <= MAX_WAITING) return
        if (waiting.poll() != null) count.decrementAndGet()
        if (!warned) warn("the agent is $MAX_WAITING snapshots behind its sensors, the oldest are dropped")
        warned = true
    }

    override fun isReady() = waiting.isNotEmpty()

    override fun take(): Snapshot? = waiting.poll()?.also { count.decrementAndGet() }

    override fun drain() = generateSequence(::take).toList()

    override fun clear() {
        drain()
    }

    companion object {
        /** The most snapshots that wait for an agent. */
        const val MAX_WAITING = 1000
    }
}
