package argo.observing

import argo.filters.CriticalRule
import argo.filters.PerceptionFilter

/**
 * Follows the events of one agent. A live view and a recorder are observers. An [AgentObserverProvider] opens an observer. An agent may
 * have several observers.
 *
 * The thread of an event calls the function. This may be the agent's thread, the sensing thread of a port, or the thread that sends
 * commands. Therefore each function must return at once and be safe for use by several threads. Agent and sensing continue if an observer
 * throws an exception. The first exception of an observer is logged. By default the functions do nothing; only [close] must be implemented.
 */
interface AgentObserver : AutoCloseable {
    /**
     * [message] has passed the filter. If the filter holds back percepts of [message], this function is called again when they are due.
     * [PerceivedMessage.receivedNanos] is then the time of the original message.
     */
    fun messageFiltered(message: PerceivedMessage) = Unit

    /** The agent perceives [message] in this reasoning cycle. Called by the agent's thread. */
    fun messagePerceived(message: PerceivedMessage) = Unit

    /** [command] waits to be sent. The agent has called `argo.act`, or a critical rule has a reflex. */
    fun commandIssued(command: IssuedCommand) = Unit

    /** [command] was sent or, in version 2, carried out. If it failed, [failure] is the reason. Called once for each [commandIssued]. */
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
     * @param reason the reason why the port is not on, for a person; null if it is not known
     */
    fun portChanged(port: String, status: String, reason: String?) = Unit

    /**
     * The agent perceives through [filter] from now on. If [filter] is null, it perceives without a filter. Called by the agent's thread.
     */
    fun filterChanged(filter: PerceptionFilter?) = Unit

    /**
     * From now on, [filter] applies only to the board on [port]. If [filter] is null, the board has no filter. Called by the agent's
     * thread.
     */
    fun boardFilterChanged(port: String, filter: PerceptionFilter?) = Unit

    /** The agent has called `argo.record(Why)`. Returns true if the observer keeps the last events. Called by the agent's thread. */
    fun recordWanted(why: String): Boolean = false

    /** A reasoning cycle is over. Called by the agent's thread, so this function may read [ObservedAgent.beliefs]. */
    fun cycleFinished() = Unit

    /** The agent ends. Release all resources, but do not wait for them. Events may still come. May be called twice. */
    override fun close()
}

/** A message of a board before and after the filter. Immutable. */
interface PerceivedMessage {
    /** The name with which the message's port was opened. */
    val portName: String

    /** The namespace of the message's percepts; null for the default namespace. */
    val namespace: String? get() = null

    /** The percepts as the board sent them. */
    val texts: List<String>

    /** The percepts that the filter lets through, and the percepts that replace held-back ones. */
    val kept: List<String>

    /** The percepts in [kept] that the agent cannot believe. The agent's log has the reason. */
    val unreadable: Set<String>

    /** The time of the message's last byte, in ns of [ObservedAgent.nanos]. */
    val receivedNanos: Long
}

/**
 * A command for a board.
 *
 * @property number the number of the command among the agent's commands, from 1
 * @property port the name with which the board's port was opened
 * @property text the text that is sent
 * @property issuedNanos the time at which the command was issued, in ns of [ObservedAgent.nanos]
 */
data class IssuedCommand(val number: Long, val port: String, val text: String, val issuedNanos: Long)

/** The watcher of a critical rule, which starts the rule's reflex. Messages call it by [word]. */
enum class RuleWatcher(val word: String) {
    BOARD("the board"),
    COMPUTER("the computer"),
}

/**
 * The reflex of a critical rule, with its outcome.
 *
 * @property watcher tells whether the board or the computer started the reflex
 * @property failure the reason why the reflex was not carried out; null if it was carried out
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
