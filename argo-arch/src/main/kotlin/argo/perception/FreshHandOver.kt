package argo.perception

import argo.filters.CriticalRule
import jason.asSyntax.Literal
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Keeps only the newest snapshot. Hands it over when the [work] that the previous snapshot has caused is done.
 *
 * A snapshot is critical if it has a critical percept that the previous snapshot did not have. A critical snapshot is handed over at once.
 * A newer critical snapshot replaces a waiting one only if it meets all critical rules of the waiting one. Therefore at most one critical
 * snapshot waits for each critical rule. If [MANY_EVENTS] wait in Jason's queue, each rule lets only one critical snapshot pass at once.
 * Further critical snapshots wait for the work, so that events do not pile up.
 *
 * Each [event][Snapshot.event] of a board is handed over in order, with the newest of all other percepts. If more than [MAX_EVENTS] wait,
 * the oldest are lost.
 *
 * @param tellLost called without the lock at each loss, with the number of events lost so far
 * @param tellLate called without the lock if snapshots have waited longer than [LATE_MS]; `why` is the kind of awaited work
 */
internal class FreshHandOver(
    private val work: UnfinishedWork,
    private val tellLost: (count: Long) -> Unit = { },
    private val tellLate: (ms: Long, why: String) -> Unit = { _, _ -> },
) : HandOver {
    private val lock = ReentrantLock()
    private val critical = ArrayDeque<Snapshot>() // snapshots with new critical percepts, in order
    private val events = LinkedBlockingQueue<PerceptEvent>() // changed only under the lock
    private var last: Snapshot? = null // the last taken snapshot, without its event
    private var lost = 0L
    private var known: Set<Literal> = emptySet() // the critical percepts of the last taken snapshot
    private val earlyRules = HashSet<CriticalRule>() // rules that have let a snapshot pass since the work was last done

    private var waitingSince: Long? = null // the time of the first message since the last hand-over, or null

    @Volatile
    private var newest: Snapshot? = null

    /** True if the next snapshot does not wait for work, see [catchUp]. */
    @Volatile
    private var isCatchingUp = false

    override fun put(snapshot: Snapshot) {
        val (nowLost, waitedMs) = lock.withLock { keep(snapshot) to waitedMs(snapshot) }
        nowLost?.let(tellLost)
        if (waitedMs > LATE_MS) work.kindLeft()?.let { tellLate(waitedMs, it) }
    }

    /** Returns the number of events lost so far if the event of [snapshot] has made one lost, else null. */
    private fun keep(snapshot: Snapshot): Long? {
        val nowLost = snapshot.event?.let(::add)
        keepNewest(snapshot.withoutEvent())
        return nowLost
    }

    private fun waitedMs(snapshot: Snapshot): Long {
        val since = waitingSince ?: snapshot.receivedNanos.also { waitingSince = it }
        return TimeUnit.NANOSECONDS.toMillis(snapshot.receivedNanos - since)
    }

    private fun keepNewest(snapshot: Snapshot) {
        val newer = newest?.takeIf { it.receivedNanos - snapshot.receivedNanos > 0 }
        if (snapshot.critical.any { it.percept !in known }) {
            val met = rules(snapshot)
            critical.removeAll { met.containsAll(rules(it)) }
            critical.addLast(snapshot)
            newest = newer
        } else {
            newest = newer ?: snapshot
        }
    }

    private fun add(event: PerceptEvent): Long? {
        events += event
        if (events.size <= MAX_EVENTS) return null
        events.poll()
        return ++lost
    }

    private fun isWaiting() = newest != null || events.isNotEmpty()

    override fun isReady(): Boolean = isReady { work.isDone() }

    private inline fun isReady(isDone: () -> Boolean): Boolean {
        val urgent = firstCritical()
        return if (urgent == null) isWaiting() && (isCatchingUp || isDone()) else mayBeEarly(urgent) || isDone()
    }

    override fun isUrgent(): Boolean = (isCatchingUp || firstCritical() != null) && isReady()

    override fun dueInMs(): Long? = if (!isWaiting()) null else work.dueInMs()

    private fun firstCritical(): Snapshot? = lock.withLock { critical.firstOrNull() }

    private fun mayBeEarly(snapshot: Snapshot) =
        work.waitingEvents < MANY_EVENTS || lock.withLock { rules(snapshot).any { it !in earlyRules } }

    override fun take(): Snapshot? {
        work.takenIn()
        if (!isWaiting() && firstCritical() == null) return null
        val isInTurn = work.isDone(isAwaited = true) || isCatchingUp
        if (!isReady { isInTurn }) return null
        return lock.withLock { next(isInTurn) }?.also { work.begin() }
    }

    private fun next(isInTurn: Boolean): Snapshot? {
        val next = critical.removeFirstOrNull() ?: (if (isInTurn) takeInTurn() else null) ?: return null
        if (isInTurn) earlyRules.clear() else earlyRules += rules(next)
        isCatchingUp = false
        known = next.critical.mapTo(HashSet()) { it.percept }
        waitingSince = null
        last = next.withoutEvent()
        return next
    }

    private fun takeInTurn(): Snapshot? {
        val state = takeNewest() ?: last?.takeIf { events.isNotEmpty() } ?: return null
        return events.poll()?.let(state::with) ?: state
    }

    private fun takeNewest(): Snapshot? = newest.also { newest = null }

    private fun rules(snapshot: Snapshot) = snapshot.critical.mapTo(HashSet()) { it.rule }

    override fun drain() = lock.withLock {
        val state = newest ?: critical.lastOrNull() ?: last
        val inTurn = generateSequence { events.poll() }.mapNotNull { state?.with(it) }.toList().ifEmpty { listOfNotNull(newest) }
        newest = null
        (critical + inTurn).sortedBy { it.receivedNanos }.also { critical.clear() }
    }

    override fun catchUp(): Int = lock.withLock {
        val late = critical.size - if (newest == null) 1 else 0
        repeat(late) { critical.removeFirst() }
        isCatchingUp = true
        maxOf(0, late)
    }

    override fun clear() = lock.withLock {
        isCatchingUp = false
        critical.clear()
        events.clear()
        last = null
        earlyRules.clear()
        known = emptySet()
        newest = null
        waitingSince = null
    }

    companion object {
        /** The time in ms after which waiting snapshots are reported. */
        const val LATE_MS = 2000L

        /** If fewer events wait, each critical snapshot is handed over at once. */
        const val MANY_EVENTS = 1000

        /** The largest number of events that wait for their hand-over. */
        const val MAX_EVENTS = 1000
    }
}
