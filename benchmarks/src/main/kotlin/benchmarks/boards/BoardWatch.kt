package benchmarks.boards

import argo.observing.AgentObserver
import argo.observing.AgentObserverProvider
import argo.observing.ObservedAgent
import argo.observing.PerceivedMessage
import benchmarks.awaitAtMost
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicLong
import java.util.logging.Logger

/**
 * Counts the messages and the perceived snapshots of an agent's [boards] boards. After all boards have been perceived once, it notes the
 * skew after each cycle with a perception. The skew is the time between the oldest and the newest snapshot. Safe for use by several
 * threads.
 */
internal class BoardWatch(private val boards: Int) : AgentObserver {
    private val sensedOf = ConcurrentHashMap<String, AtomicLong>()
    private val perceivedOf = ConcurrentHashMap<String, AtomicLong>()
    private val newest = HashMap<String, Long>() // used only by the agent's thread
    private val skews = ArrayList<Long>() // guarded by this list
    private var isNew = false

    override fun messageFiltered(message: PerceivedMessage) = count(sensedOf, message)

    override fun messagePerceived(message: PerceivedMessage) {
        count(perceivedOf, message)
        newest[message.portName] = message.receivedNanos
        isNew = true
    }

    private fun count(counts: ConcurrentHashMap<String, AtomicLong>, message: PerceivedMessage) {
        counts.computeIfAbsent(message.portName) { AtomicLong() }.incrementAndGet()
    }

    override fun cycleFinished() {
        if (!isNew) return
        isNew = false
        if (newest.size == boards) synchronized(skews) { skews += newest.values.max() - newest.values.min() }
    }

    fun sensed(): Map<String, Long> = sensedOf.mapValues { (_, count) -> count.get() }

    fun perceived(): Map<String, Long> = perceivedOf.mapValues { (_, count) -> count.get() }

    /** Waits for up to [seconds] s until the agent has perceived all boards. */
    fun awaitAll(seconds: Int) = check(awaitAtMost(seconds) { perceivedOf.size == boards }) {
        "only ${perceivedOf.size} of $boards boards are perceived"
    }

    /** Returns the skews that were noted since the last call, in ns. */
    fun takeSkews(): LongArray = synchronized(skews) { skews.toLongArray().also { skews.clear() } }

    override fun close() = Unit

    companion object {
        /** The option of a watched agent. The option's value is the number of the agent's boards. */
        const val OPTION = "argo_watched"

        private val watches = ConcurrentHashMap<String, BoardWatch>()

        fun of(name: String): BoardWatch = watches.getValue(name)

        fun open(name: String, boards: Int): BoardWatch = BoardWatch(boards).also { watches[name] = it }
    }
}

internal fun leastMore(before: Map<String, Long>, after: Map<String, Long>): Long =
    after.minOf { (port, count) -> count - before.getOrDefault(port, 0) }

/** Makes a [BoardWatch] for the option `[argo_watched=8]`, here of eight boards. */
class BoardWatchProvider : AgentObserverProvider {
    override val option = BoardWatch.OPTION
    override val usage = "the number of its boards"

    override fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver = BoardWatch.open(agent.name, value.toInt())
}
