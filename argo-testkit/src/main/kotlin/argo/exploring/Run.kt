package argo.exploring

import kotlin.time.Duration

/** An entry of a run's trace. Immutable. */
sealed interface TraceEntry {
    /** The time of the entry since the run began. */
    val at: Duration
}

/** An action of [agent], or an event that happens to it. */
sealed interface AgentEntry : TraceEntry {
    /** The agent's name. */
    val agent: String
}

/** [event] begins. */
data class Happened(override val at: Duration, val event: WorldEvent) : TraceEntry

/** A message of the board on [port] has come. The agent perceives it soon, or never if a newer message comes first. */
data class Received(override val at: Duration, override val agent: String, val port: String) : AgentEntry

/**
 * The agent perceives a message of the board on [port]. The message's last byte came at [received], and the filter let [percepts] through.
 */
data class Perceived(
    override val at: Duration,
    override val agent: String,
    val port: String,
    val percepts: List<String>,
    val received: Duration,
) : AgentEntry

/**
 * The agent has called `argo.act`, or a reflex was sent.
 *
 * @property number counts the agent's commands
 * @property plan the plan that called `argo.act`, with file and line; null: no plan sent the command
 */
data class Issued(
    override val at: Duration,
    override val agent: String,
    val number: Long,
    val port: String,
    val command: String,
    val plan: String?,
) : AgentEntry

/** An agent's command has ended. [error] is the atom in `error(…)`; null: the command was sent or, in version 2, carried out. */
data class Ended(
    override val at: Duration,
    override val agent: String,
    val number: Long,
    val command: String,
    val error: String?,
) : AgentEntry

/** The state of a port of the agent: `on`, `off` or `timeout`. */
data class PortChanged(override val at: Duration, override val agent: String, val port: String, val status: String) : AgentEntry

/** The numbers of an agent's beliefs, intentions and events after a reasoning cycle that changed them. */
data class MindSize(override val at: Duration, override val agent: String, val beliefs: Int, val intentions: Int, val events: Int) :
    AgentEntry

/** The agent's [intention] has waited at one step since the time [since]. Recorded at the end of a run. */
data class Waits(override val at: Duration, override val agent: String, val intention: String, val since: Duration) : AgentEntry

/** A plan of the agent has failed, and no plan handled the failure. [what] is Jason's message. */
data class FailedUnhandled(override val at: Duration, override val agent: String, val what: String) : AgentEntry

/** The agent has printed [text]. */
data class Printed(override val at: Duration, override val agent: String, val text: String) : AgentEntry

/** The agent has sent a message to another agent: `tell(bob,ready)`. */
data class Said(override val at: Duration, override val agent: String, val message: String) : AgentEntry

/** The agent has ended. */
data class Stopped(override val at: Duration, override val agent: String) : AgentEntry

/** An agent reasons without end, so that virtual time does not advance. The run ends here. */
data class NeverRests(override val at: Duration, val what: String) : TraceEntry

/**
 * The events of a run from its beginning to its end.
 *
 * @property events the events of the world, in the order of their times
 * @property trace all recorded entries, in the order of their times
 * @property ended the time at which the run ended, since it began
 * @property arrived the commands that have arrived at each board, in the order of arrival
 * @property opened the ports that the agents have opened
 */
class Run internal constructor(
    val events: List<WorldEvent>,
    val trace: List<TraceEntry>,
    val ended: Duration,
    val agents: List<String>,
    val arrived: Map<String, List<String>>,
    internal val opened: Set<String>,
) {
    /** Returns the entries of [agent]. */
    fun of(agent: String): List<AgentEntry> = trace.filterIsInstance<AgentEntry>().filter { it.agent == agent }

    private fun entry(index: Int): Any = trace.getOrNull(index) ?: "nothing"

    /** Describes how this run differs from [other], a run with the same events; null: they are equal. */
    internal fun differenceFrom(other: Run): String? {
        val pairs = trace.size.coerceAtLeast(other.trace.size)
        val first = (0 until pairs).firstOrNull { trace.getOrNull(it) != other.trace.getOrNull(it) }
        return when {
            first != null -> "${entry(first)} the first time, ${other.entry(first)} the second time"
            arrived != other.arrived -> "the boards have received $arrived the first time, ${other.arrived} the second time"
            else -> null
        }
    }
}
