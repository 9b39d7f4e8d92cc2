package argo.view

import argo.filters.PerceptionFilter
import argo.observing.AgentObserver
import argo.observing.CommandFailure
import argo.observing.IssuedCommand
import argo.observing.PerceivedMessage
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicLong

/**
 * What has happened to an agent lately, kept for its view. What is kept is bounded, however much happens.
 *
 * Safe for use by several threads; the threads of the agent leave a note and go on.
 *
 * @param nanos a clock in ns that never goes back
 */
internal class AgentRecord(private val beliefs: BeliefWatch, private val nanos: () -> Long) : AgentObserver {
    /** The agent's commands. */
    val commands = CommandRecord(nanos)

    /** What its boards said. */
    val frames = FrameRecord()

    private val portChanges = ConcurrentHashMap<String, PortChange>()
    private val changes = AtomicLong()
    private val handOvers = AtomicLong()
    private val cycles = AtomicLong()

    /** The active filter. */
    @Volatile
    var filter: PerceptionFilter? = null
        private set

    /** When the agent last perceived a message. */
    @Volatile
    var lastHandOver: HandedOver? = null
        private set

    /** Another number after each event but the end of a cycle. */
    val version: Long get() = changes.get()

    /** What has happened so far, counted. */
    fun counts() = Counts(frames.count, handOvers.get(), commands.count, cycles.get())

    /** How [port] came into the state it is in; null: not known. */
    fun changeOf(port: String): PortChange? = portChanges[port]

    override fun messageFiltered(message: PerceivedMessage) = changing { frames.add(message) }

    override fun messagePerceived(message: PerceivedMessage) = changing {
        handOvers.incrementAndGet()
        val now = nanos()
        lastHandOver = HandedOver(now, now - message.receivedNanos)
    }

    override fun commandIssued(command: IssuedCommand) = changing { commands.issued(command) }

    override fun commandEnded(command: IssuedCommand, failure: CommandFailure?) = changing { commands.ended(command, failure) }

    override fun portChanged(port: String, status: String, reason: String?) = changing {
        if (portChanges.size < MOST_PORTS) portChanges[port] = PortChange(status, reason?.let(::shown), nanos())
    }

    override fun filterChanged(filter: PerceptionFilter?) = changing { this.filter = filter }

    override fun cycleFinished() {
        cycles.incrementAndGet()
        beliefs.cycleFinished()
    }

    /** There is nothing to give back. */
    override fun close() = Unit

    private inline fun changing(event: () -> Unit) {
        event()
        changes.incrementAndGet()
    }

    /** A port came into the state [status] at [nanos]. */
    data class PortChange(val status: String, val reason: String?, val nanos: Long)

    /** A message was perceived at [nanos], [delayNanos] after its last byte. */
    data class HandedOver(val nanos: Long, val delayNanos: Long)

    private companion object {
        /** As many names as ports can have states, twice. */
        const val MOST_PORTS = 256
    }
}

/** How many messages came, were handed to the agent, how many commands were done or failed, and how many cycles there were. */
internal data class Counts(val frames: Long, val handOvers: Long, val commands: Long, val cycles: Long)
