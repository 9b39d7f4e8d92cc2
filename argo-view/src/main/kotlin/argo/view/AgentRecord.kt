package argo.view

import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import argo.observing.AgentObserver
import argo.observing.CommandFailure
import argo.observing.EndedReflex
import argo.observing.IssuedCommand
import argo.observing.ObservedAgent
import argo.observing.PerceivedMessage
import java.util.concurrent.locks.ReentrantLock
import java.util.logging.Logger
import kotlin.concurrent.withLock

/**
 * Records the latest events of [agent] for its view, in bounded memory. Safe for use by several threads. Each event holds the lock briefly.
 */
internal class AgentRecord(private val agent: ObservedAgent, log: Logger) : AgentObserver {
    val mind = MindWatch({ MindState.of(agent) }, log, agent::nanos)

    private val lock = ReentrantLock()
    private val commands = CommandRecord()
    private val portChanges = HashMap<String, PortChange>()
    private val unseen = ArrayDeque<PerceivedMessage>()
    private var lastReceived: Long? = null
    private var filter: PerceptionFilter? = null
    private val reflexes = HashMap<CriticalRule, EndedReflex>()
    private var lastPerception: PerceptionTime? = null
    private var counts = Counts(0, 0, 0, 0)
    private var changes = 0L
    private val printed = LogLines(agent::nanos) { changing {} }

    /** A number that grows with each event, but not at the end of a cycle. */
    val version: Long get() = lock.withLock { changes }

    /** Reads the agent's log from now on, until [close]. */
    fun begin() = agent.printed.addHandler(printed)

    /** Returns the whole record at [now]. [Recorded.unseen] has the messages since the last call. */
    fun take(now: Long): Recorded = lock.withLock {
        val counted = counts.copy(commands = commands.count)
        Recorded(
            counted, filter, lastPerception, unseen.toList(), portChanges.toMap(), commands.state(now), reflexes.toMap(),
            printed.state(now),
        ).also { unseen.clear() }
    }

    /** Returns the messages since the last call or [take]. */
    fun takeUnseen(): List<PerceivedMessage> = lock.withLock { unseen.toList().also { unseen.clear() } }

    override fun messageFiltered(message: PerceivedMessage) = changing {
        if (message.receivedNanos != lastReceived) counts = counts.copy(frames = counts.frames + 1)
        lastReceived = message.receivedNanos
        if (unseen.size == MAX_UNSEEN) unseen.removeFirst()
        unseen += message
    }

    override fun messagePerceived(message: PerceivedMessage) = changing {
        counts = counts.copy(handOvers = counts.handOvers + 1)
        val now = agent.nanos()
        lastPerception = PerceptionTime(now, now - message.receivedNanos)
    }

    override fun commandIssued(command: IssuedCommand) = changing { commands.issued(command) }

    override fun commandEnded(command: IssuedCommand, failure: CommandFailure?) =
        changing { commands.ended(command, failure, agent.nanos()) }

    override fun portChanged(port: String, status: String, reason: String?) = changing {
        if (portChanges.size < MAX_PORTS) portChanges[port] = PortChange(status, reason?.let(::shown), agent.nanos())
    }

    override fun filterChanged(filter: PerceptionFilter?) = changing {
        this.filter = filter
        reflexes.keys.retainAll(filter?.critical.orEmpty().toSet())
    }

    override fun reflexEnded(reflex: EndedReflex) = changing {
        if (reflex.rule in filter?.critical.orEmpty()) reflexes[reflex.rule] = reflex
    }

    override fun cycleFinished() {
        lock.withLock { counts = counts.copy(cycles = counts.cycles + 1) }
        mind.look()
    }

    override fun close() = agent.printed.removeHandler(printed)

    private inline fun changing(event: () -> Unit) = lock.withLock {
        event()
        changes++
        Unit
    }

    private companion object {
        const val MAX_PORTS = 256

        /** The largest number of messages that wait to be shown. A board sends so many in 0.1 s at 115200 baud, one percept in each. */
        const val MAX_UNSEEN = 64
    }
}

/**
 * The content of a record at one moment.
 *
 * @property ports the last change of each port's state, by the port's name
 * @property reflexes the last outcome of the reflexes of the active filter
 */
internal class Recorded(
    val counts: Counts,
    val filter: PerceptionFilter?,
    val lastPerception: PerceptionTime?,
    val unseen: List<PerceivedMessage>,
    val ports: Map<String, PortChange>,
    val commands: CommandsState,
    val reflexes: Map<CriticalRule, EndedReflex>,
    val printed: List<LineState>,
)

internal class PortChange(val status: String, val reason: String?, val nanos: Long)

internal class PerceptionTime(val nanos: Long, val delayNanos: Long)

/** The numbers of received messages, of perceived messages, of commands that have ended, and of cycles. */
internal data class Counts(val frames: Long, val handOvers: Long, val commands: Long, val cycles: Long)
