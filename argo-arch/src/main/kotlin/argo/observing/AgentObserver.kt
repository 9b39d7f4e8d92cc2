package argo.observing

import argo.filters.CriticalRule
import argo.filters.PerceptionFilter

/**
 * Follows the events of one agent, like its live view or a recorder. An [AgentObserverProvider] opens an observer; an agent may have
 * several observers.
 *
 * The thread of the event calls each function: the agent's, the sensing thread of a port, or the thread that sends commands. So a function
 * must return at once and be safe for use by several threads. Exceptions are caught: they end neither the agent nor its sensing. The first
 * exception of an observer is logged. By default the functions do nothing; only [close] must be implemented.
 */
interface AgentObserver : AutoCloseable {
    /**
     * [message] has passed through the filter. Called again, with the same [PerceivedMessage.receivedNanos], when held-back percepts are
     * due.
     */
    fun messageFiltered(message: PerceivedMessage) = Unit

    /** The agent perceives [message] in this reasoning cycle. Called by the agent's thread. */
    fun messagePerceived(message: PerceivedMessage) = Unit

    /** [command] waits to be sent: the agent has called `argo.act`, or a critical rule has a reflex. */
    fun commandIssued(command: IssuedCommand) = Unit

    /** [command] has been sent or, in version 2, carried out; else [failure] is the reason. Called once for each [commandIssued]. */
    fun commandEnded(command: IssuedCommand, failure: CommandFailure?) = Unit

    /**
     * The outcome of [reflex] is known. The agent believes it as `reflex(Command,done)` or `reflex(Command,failed)`. A reflex that the
     * computer sends is also reported as a command.
     */
    fun reflexEnded(reflex: EndedReflex) = Unit

    /**
     * A port has changed its state.
     *
     * @param port the agent's term for the port
     * @param status `on`, `off` or `timeout`
     * @param reason the reason why the port is not on, for a person; null: it is not known
     */
    fun portChanged(port: String, status: String, reason: String?) = Unit

    /** The agent perceives through [filter] from now on; null: through none. Called by the agent's thread. */
    fun filterChanged(filter: PerceptionFilter?) = Unit

    /** The agent perceives only the board on [port] through [filter] from now on; null: through none. Called by the agent's thread. */
    fun boardFilterChanged(port: String, filter: PerceptionFilter?) = Unit

    /** The agent has called `argo.record(Why)`. Returns true if the observer keeps the last events. Called by the agent's thread. */
    fun recordWanted(why: String): Boolean = false

    /** A reasoning cycle is over. Called by the agent's thread, so this is the place to read [ObservedAgent.beliefs]. */
    fun cycleFinished() = Unit

    /** The agent ends. Releases all resources without waiting for them; events may still come. May be called twice. */
    override fun close()
}

/** A message of a board before and after the filter. Immutable. */
interface PerceivedMessage {
    /** The name with which the message's port was opened. */
    val portName: String

    /** The namespace of its percepts; null: the default namespace. */
    val namespace: String? get() = null

    /** The percepts as they came off the line. */
    val texts: List<String>

    /** The percepts that the filter lets through, and stand-ins for held-back ones. */
    val kept: List<String>

    /** The percepts in [kept] that cannot be believed; the agent's log has the reason. */
    val unreadable: Set<String>

    /** The time of the message's last byte, in ns of [ObservedAgent.nanos]. */
    val receivedNanos: Long
}

/**
 * A command for a board.
 *
 * @property number counts the agent's commands, from 1
 * @property port the name with which the board's port was opened
 * @property text the text that is sent
 * @property issuedNanos the time of its issue, in ns of [ObservedAgent.nanos]
 */
data class IssuedCommand(val number: Long, val port: String, val text: String, val issuedNanos: Long)

/** The side that watches a critical rule and has the rule's reflex carried out. The [word] is for people. */
enum class RuleWatcher(val word: String) {
    BOARD("the board"),
    COMPUTER("the computer"),
}

/**
 * The reflex of a critical rule, with its outcome.
 *
 * @property watcher the side that had the reflex carried out
 * @property failure the reason why the reflex was not carried out; null: it was
 * @property nanos the time at which the outcome was known, in ns of [ObservedAgent.nanos]
 */
data class EndedReflex(val rule: CriticalRule, val watcher: RuleWatcher, val failure: CommandFailure?, val nanos: Long)

/** The reason why a command was not carried out. */
interface CommandFailure {
    /** The atom in the annotation `error(…)` of the failed plan. */
    val error: String

    /** The finding and the remedy, for a person. */
    val cause: String
}
