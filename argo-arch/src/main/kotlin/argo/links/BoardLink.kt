package argo.links

import argo.filters.PerceptionFilter
import javino.PerceptKind
import javino.PortException
import javino.PortGoneException
import javino.PortTimeoutException
import javino.link.BoardListener
import javino.link.SendOptions
import javino.wire.BoardAction
import javino.wire.CommandItem
import java.util.concurrent.CompletableFuture

/**
 * An open port through which one agent exchanges messages with a board: a line that carries bytes ([JavinoLink]), or the link of a
 * [BoardLinkProvider].
 *
 * Safe for use by several threads. If the far end has gone or the link is closed, every call except [close] and [wants] promptly fails with
 * [PortGoneException], even a call that waits. Only [listen], [request], [perceptKinds], [check], [watch], [writeCommandsUntilClosed] and
 * [sendAndAwait] may wait.
 */
interface BoardLink : AutoCloseable {
    /** The port's name, as given. */
    val port: String

    /** True if the link can be used: it was not closed, and no call has found the far end gone. */
    val isOpen: Boolean

    /** True if threads of the port sense and write; false: the agent's own thread does so, under `argo_sensing=in_cycle`. */
    val isPaced: Boolean

    /** True if the board sends messages by itself at the interval of [wants]: it is listened to and never asked. */
    val speaksUnasked: Boolean get() = false

    /** True if a command goes out as bytes, one a character; false: the link itself parses the text. */
    val isLine: Boolean get() = false

    /** True if the board can be asked for some percepts, as `getPercepts(dist)`. */
    val canSelect: Boolean get() = false

    /** True if the far end may vanish unnoticed. Such a link is worth reopening after a long silence. */
    val mayVanish: Boolean get() = false

    /** The actions that the board has registered; null: they are not known. Does not wait. */
    val actions: List<BoardAction>? get() = null

    /** Takes the agent's wishes to the board. Called at each change, by any thread; does not wait. */
    fun wants(wish: Wish) = Unit

    /**
     * Waits for the next message.
     *
     * @param timeoutMs milliseconds to wait at most, at least 1
     * @return null: the board has nothing to say
     * @throws PortTimeoutException if a message was due, or the board gave no sign of life
     */
    @Throws(PortException::class)
    fun listen(timeoutMs: Int): BoardMessage?

    /**
     * Asks for a message and waits for it. Not called if the board [speaks unasked][speaksUnasked].
     *
     * @param text returns the request; called when it goes out
     * @param timeoutMs milliseconds that the board has to answer, at least 1
     * @param intervalMs milliseconds between requests
     * @throws PortTimeoutException if no answer came
     */
    @Throws(PortException::class)
    fun request(text: () -> String, timeoutMs: Int, intervalMs: Int): BoardMessage =
        throw UnsupportedOperationException("$port speaks unasked")

    /** Checks that the far end is still there, without waiting for it. */
    @Throws(PortException::class)
    fun check()

    /** Waits for the board's reports, see [onBoardEvents], for [timeoutMs] ms at most, and passes them on. */
    @Throws(PortException::class)
    fun watch(timeoutMs: Int) = check()

    /**
     * Asks the board for the kinds of its percepts, and waits [timeoutMs] ms at most. Returns an empty list if the board describes none.
     * @throws PortTimeoutException if no answer came
     */
    @Throws(PortException::class)
    fun perceptKinds(timeoutMs: Int): List<PerceptKind> = emptyList()

    /** Returns true if the command [text] has an [Answer] as its outcome. */
    fun answers(text: String): Boolean = false

    /** Sends [text] as a command without waiting. */
    fun send(text: String, options: SendOptions): SentCommand

    /** Sends a command that changes the board's critical rules, without waiting. Only for boards that have reported room for rules. */
    fun sendRule(rule: CommandItem.Rule, options: SendOptions): SentCommand = throw UnsupportedOperationException("$port holds no rules")

    /** Sends [text] as a command and waits for its outcome. Returns the answer; null: the far end does not answer such commands. */
    @Throws(PortException::class)
    fun sendAndAwait(text: String, options: SendOptions): Answer?

    /**
     * Takes queued commands to the board on the calling thread until the link is closed. Returns at once if the link needs no such thread.
     */
    @Throws(PortException::class)
    fun writeCommandsUntilClosed() = Unit

    /** Sets the listener for the board's own reports. Only boards that can hold rules send reports. */
    fun onBoardEvents(listener: BoardListener) = Unit

    /** Announces [close]: another opening of the port waits until the port is free. Does not wait. */
    fun leave() = Unit

    /** Closes the link. Idempotent. */
    override fun close()
}

/**
 * The wishes of an agent to a board. Immutable.
 *
 * @property isSensed whether the agent perceives the board
 * @property intervalMs the sensing interval in ms, 0: as fast as possible
 * @property filter the filter of the percepts; null: all are kept
 */
class Wish(val isSensed: Boolean, val intervalMs: Int, val filter: PerceptionFilter?)

/**
 * A message of a board. Immutable.
 *
 * @property text the message's percepts, each with its `;`
 * @property receivedNanos the arrival time of the message's end, by the platform's clock
 * @property seenNanos by percept older than the message, the time at which it was true, by the same clock
 * @property event the percept in [text] that the agent perceives in its turn, even if newer messages have come; empty: no percept, but the
 * gap between two equal ones; null: the message has no such percept
 */
class BoardMessage(
    val text: String,
    val receivedNanos: Long,
    val seenNanos: Map<String, Long> = emptyMap(),
    val event: String? = null,
)

/**
 * A command on its way. Each future is completed once, by any thread and outside of any lock, with a [PortException] if it fails.
 *
 * @property outcome the outcome of the command: an [Answer], if the far end [answers][BoardLink.answers] such commands
 * @property left the end of the command's way to the board; completes no later than [outcome]. The agent gets no new snapshot before that
 * end. If the outcome takes long, as that of a robot's journey does, this is a separate future
 * @property giveUp ends the command early, without waiting: withdraws it, or tells the far end to stop; null: neither is possible
 */
class SentCommand(
    val outcome: CompletableFuture<*>,
    val left: CompletableFuture<*> = outcome,
    val giveUp: (() -> Unit)? = null,
)

/**
 * The answer of a board to a command. Immutable.
 *
 * @property text the text of a term; null: there is none
 * @property why the reason why there is no text, in words; null: there is one
 */
class Answer private constructor(val text: String?, val why: String?) {
    companion object {
        fun of(text: String) = Answer(text, null)

        fun none(why: String) = Answer(null, why)
    }
}
