package argo.perception

import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.atomic.AtomicInteger

/**
 * Passes snapshots from the sensing thread to the agent's thread. Neither thread waits for the other. The agent's thread calls [take] in
 * each perception. Any thread may call the other functions.
 */
internal interface HandOver {
    /** Keeps [snapshot] for the agent. May drop it if there is a snapshot of a newer message. */
    fun put(snapshot: Snapshot)

    /** Returns true if [take] would return a snapshot now. */
    fun isReady(): Boolean

    /** Returns true if [take] would return a snapshot now, and this snapshot does not wait for other boards' answers. */
    fun isUrgent(): Boolean = isReady()

    /** Returns the ms after which a snapshot may become ready without news; null if none may become ready. */
    fun dueInMs(): Long? = null

    /** Removes and returns the snapshot that the agent perceives now; null if none is ready. */
    fun take(): Snapshot?

    /** Removes and returns all snapshots, in the order of their messages. */
    fun drain(): List<Snapshot>

    /**
     * Called after a pause of the agent. Drops all snapshots except the newest. The agent gets the newest one next, even if work is left.
     * Returns how many of the dropped snapshots the agent would have perceived.
     */
    fun catchUp(): Int

    /** Forgets the snapshots that have not been taken, and the critical percepts of the taken ones. */
    fun clear()
}

/**
 * Hands over every snapshot, in order. If more than [MAX_WAITING] snapshots wait, the oldest is lost. Warns at the first loss.
 *
 * @param isCrowded returns true if too many events wait in Jason's queue. Then no snapshot is handed over. Jason puts the event of a new
 * goal behind all waiting events, so a slow agent would reach its own goals later and later.
 */
internal class EveryHandOver(private val isCrowded: () -> Boolean = { false }, private val warn: (String) -> Unit) : HandOver {
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

    override fun isReady() = waiting.isNotEmpty() && !isCrowded()

    override fun take(): Snapshot? = if (isReady()) poll() else null

    private fun poll(): Snapshot? = waiting.poll()?.also { count.decrementAndGet() }

    override fun drain() = generateSequence(::poll).toList()

    override fun catchUp(): Int {
        val all = drain()
        all.lastOrNull()?.let(::put)
        return maxOf(0, all.size - 1)
    }

    override fun clear() {
        drain()
    }

    companion object {
        const val MAX_WAITING = 1000
    }
}
