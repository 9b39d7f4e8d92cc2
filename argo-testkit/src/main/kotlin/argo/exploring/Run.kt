package argo.exploring

import kotlin.time.Duration

/** Something that a run has shown, at a time since it began. Does not change. */
sealed interface TraceEntry {
    /** When it was. */
    val at: Duration
}

/** What [agent] does or what happens to it. */
sealed interface AgentEntry : TraceEntry {
    /** The name of the agent. */
    val agent: String
}

/** [event] begins. */
data class Happened(override val at: Duration, val event: WorldEvent) : TraceEntry

/** A message of the board on [port] has come, which the agent perceives soon, or never if a newer one comes before. */
data class Received(override val at: Duration, override val agent: String, val port: String) : AgentEntry

/** The agent perceives a message of the board on [port], whose last byte came at [received]; the filter let [percepts] through. */
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
 * @property plan the plan that did it, with file and line; null: none did
 */
data class Issued(
    override val at: Duration,
    override val agent: String,
    val number: Long,
    val port: String,
    val command: String,
    val plan: String?,
) : AgentEntry

/** Command [number] of the agent has left, or the board has acted; else [error] is the atom in `error(…)`. */
data class Ended(
    override val at: Duration,
    override val agent: String,
    val number: Long,
    val command: String,
    val error: String?,
) : AgentEntry

/** The state of a port of the agent: `on`, `off` or `timeout`. */
data class PortChanged(override val at: Duration, override val agent: String, val port: String, val status: String) : AgentEntry

/** How much the agent has in mind after a reasoning cycle. Recorded when it has changed. */
data class MindSize(override val at: Duration, override val agent: String, val beliefs: Int, val intentions: Int, val events: Int) :
    AgentEntry

/** The agent waits with [intention], which it is at the same step of since [since]. Recorded at the end of a run. */
data class Waits(override val at: Duration, override val agent: String, val intention: String, val since: Duration) : AgentEntry

/** A plan of the agent has failed and there was no plan for that. [what] is Jason's message. */
data class FailedUnhandled(override val at: Duration, override val agent: String, val what: String) : AgentEntry

/** The agent has printed [text]. */
data class Printed(override val at: Duration, override val agent: String, val text: String) : AgentEntry

/** The agent has sent a message to another one: `tell(bob,ready)`. */
data class Said(override val at: Duration, override val agent: String, val message: String) : AgentEntry

/** The agent has ended. */
data class Stopped(override val at: Duration, override val agent: String) : AgentEntry

/** An agent reasons without an end, so that time stands still; the run ends with it. */
data class NeverRests(override val at: Duration, val what: String) : TraceEntry

/**
 * What has happened from the beginning of a run to its end.
 *
 * @property events what drove it, in the order of their times
 * @property trace all that was recorded, in the order of the times
 * @property ended how long it was
 * @property agents the names of its agents
 * @property arrived the commands that have arrived at each board, in their order
 */
class Run internal constructor(
    val events: List<WorldEvent>,
    val trace: List<TraceEntry>,
    val ended: Duration,
    val agents: List<String>,
    val arrived: Map<String, List<String>>,
) {
    /** What was recorded of [agent]. */
    fun of(agent: String): List<AgentEntry> = trace.filterIsInstance<AgentEntry>().filter { it.agent == agent }

    private fun entry(index: Int): Any = trace.getOrNull(index) ?: "nothing"

    /** What differs in [other], which was driven by the same events, for a person; null: nothing does. */
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
