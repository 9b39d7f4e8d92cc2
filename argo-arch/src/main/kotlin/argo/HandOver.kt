package argo

import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicReference

/**
 * Where the sensing thread leaves snapshots and the reasoning cycle takes them, without either waiting for the other.
 *
 * [take] belongs to the agent's thread and is called in each of its perceptions; the others may be called by any.
 */
internal interface HandOver {
    /** Leaves [snapshot] for the agent; one of an older message than what is there already may be left out. */
    fun put(snapshot: Snapshot)

    /** Whether [take] would give one now. */
    fun isReady(): Boolean

    /** The snapshot to perceive now, or null. */
    fun take(): Snapshot?

    /** Forgets what has not been taken. */
    fun clear()
}

/**
 * Keeps the newest snapshot only and hands it over when
 * 1. the percept events of the one before have been taken from Jason's event queue, and
 * 2. every command that was issued before the hand-over of the one before has gone out, failed or timed out.
 *
 * Without (1) events pile up, since Jason handles one a cycle; without (2) commands do, since the line is slower than the
 * agent. Waiting for all commands would starve the sensing of a plan that loops on `argo.act`.
 */
internal class FreshHandOver(private val commands: CommandLedger, private val events: PerceptEvents) : HandOver {
    private val newest = AtomicReference<Snapshot?>()

    @Volatile
    private var commandsToAwait = 0L

    override fun put(snapshot: Snapshot) {
        newest.updateAndGet { if (it != null && it.receivedNanos - snapshot.receivedNanos > 0) it else snapshot }
    }

    override fun isReady() = newest.get() != null && commands.allDoneUpTo(commandsToAwait) && !events.wait()

    override fun take(): Snapshot? {
        events.takenIn()
        if (!isReady()) return null
        return newest.getAndSet(null)?.also {
            commandsToAwait = commands.lastIssued()
            events.handedOver()
        }
    }

    override fun clear() = newest.set(null)
}

/** Hands over every snapshot in its order; an agent that is [MOST_WAITING] behind loses the oldest, with one warning. */
internal class EveryHandOver(private val warn: (String) -> Unit) : HandOver {
    private val waiting = ConcurrentLinkedQueue<Snapshot>()
    private val count = AtomicInteger()
    private var warned = false

    override fun put(snapshot: Snapshot) {
        waiting.add(snapshot)
        if (count.incrementAndGet() <= MOST_WAITING) return
        if (waiting.poll() != null) count.decrementAndGet()
        if (!warned) warn("the agent is $MOST_WAITING snapshots behind its sensors, the oldest are dropped")
        warned = true
    }

    override fun isReady() = waiting.isNotEmpty()

    override fun take(): Snapshot? = waiting.poll()?.also { count.decrementAndGet() }

    override fun clear() {
        while (true) take() ?: return
    }

    companion object {
        /** The most snapshots that wait for an agent. */
        const val MOST_WAITING = 1000
    }
}
