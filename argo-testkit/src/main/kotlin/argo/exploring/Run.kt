package argo.exploring

import kotlin.time.Duration

/** An entry of a run's trace. Immutable. */
sealed interface TraceEntry {
    /** The time since the run began. */
    val at: Duration
}

/** Something that [agent] does or that happens to it. */
sealed interface AgentEntry : TraceEntry {
    /** The agent's name. */
    val agent: String
}

/** [event] starts. */
data class Happened(override val at: Duration, val event: WorldEvent) : TraceEntry

/**
 * A message of the board on [port] has arrived. The agent perceives it soon. If a newer message arrives first, the agent never perceives
 * it.
 */
data class Received(override val at: Duration, override val agent: String, val port: String) : AgentEntry

/**
 * The agent perceives a message of the board on [port]. The message's last byte arrived at [received]. [percepts] are those that passed the
 * filter.
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
 * @property number the number of the command among the agent's commands
 * @property plan the plan that called `argo.act`, with file and line, or null for a reflex
 */
data class Issued(
    override val at: Duration,
    override val agent: String,
    val number: Long,
    val port: String,
    val command: String,
    val plan: String?,
) : AgentEntry

/**
 * An agent's command has finished. [error] is the atom in `error(…)`, or null for success. In version 1, success means that the command was
 * sent. In version 2, it means that it was carried out.
 */
data class Ended(
    override val at: Duration,
    override val agent: String,
    val number: Long,
    val command: String,
    val error: String?,
) : AgentEntry

/** A port of the agent has the new state `on`, `off` or `timeout`. */
data class PortChanged(override val at: Duration, override val agent: String, val port: String, val status: String) : AgentEntry

/** The numbers of an agent's beliefs, intentions and events after a cycle that changed one of them. */
data class MindSize(override val at: Duration, override val agent: String, val beliefs: Int, val intentions: Int, val events: Int) :
    AgentEntry

/** The agent's [intention] has waited at one step since [since]. Recorded at the end of a run. */
data class Waits(override val at: Duration, override val agent: String, val intention: String, val since: Duration) : AgentEntry

/** A plan of the agent has failed without a plan for the failure. [what] is Jason's message. */
data class FailedUnhandled(override val at: Duration, override val agent: String, val what: String) : AgentEntry

/** The agent has printed [text]. */
data class Printed(override val at: Duration, override val agent: String, val text: String) : AgentEntry

/** The agent has sent a message to another agent, such as `tell(bob,ready)`. */
data class Said(override val at: Duration, override val agent: String, val message: String) : AgentEntry

/** The agent has ended. */
data class Stopped(override val at: Duration, override val agent: String) : AgentEntry

/** An agent reasons without end, and virtual time does not advance. The run ends here. */
data class NeverRests(override val at: Duration, val what: String) : TraceEntry

/**
 * The events of a run.
 *
 * @property events the events of the world, in order of time
 * @property trace all recorded entries, in order of time
 * @property ended the length of the run
 * @property arrived the commands of each board, in order of arrival
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
    fun of(agent: String): List<AgentEntry> = trace.filterIsInstance<AgentEntry>().filter { it.agent == agent }

    private fun entry(index: Int): Any = trace.getOrNull(index) ?: "nothing"

    /** Describes the first difference between this run and [other], a run with equal events, or returns null if there is none. */
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
