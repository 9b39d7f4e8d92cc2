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
 * An open port through which one agent exchanges messages with a board. The port is a line that carries bytes ([JavinoLink]), or the link
 * of a [BoardLinkProvider].
 *
 * Safe for use by several threads. If the far end has gone or the link is closed, calls promptly fail with [PortGoneException], even calls
 * that wait. Only [close] and [wants] never fail in this way. Only [listen], [request], [perceptKinds], [check], [watch],
 * [writeCommandsUntilClosed] and [sendAndAwait] may wait.
 */
interface BoardLink : AutoCloseable {
    /** The port's name, as given. */
    val port: String

    /** True if the link was not closed, and no call has found the far end gone. */
    val isOpen: Boolean

    /**
     * True if separate threads sense and write. Under `argo_sensing=in_cycle` the agent's own thread senses and writes, and this is false.
     */
    val isPaced: Boolean

    /** True if the board sends messages without requests, at the interval given to [wants]. ARGO then sends no requests. */
    val speaksUnasked: Boolean get() = false

    /** True if a command goes out as text, one byte for each character. False if the link itself parses the text. */
    val isLine: Boolean get() = false

    /** True if a request can name the wanted percepts, as `getPercepts(dist)`. */
    val canSelect: Boolean get() = false

    /** True if the far end may vanish unnoticed. After a long silence, ARGO opens the link again. */
    val mayVanish: Boolean get() = false

    /** The actions that the board has registered; null if they are not known. Does not wait. */
    val actions: List<BoardAction>? get() = null

    /** Tells the board what the agent wants of it. Called at each change, by any thread. Does not wait. */
    fun wants(wish: Wish) = Unit

    /**
     * Waits for the next message.
     *
     * @param timeoutMs the longest wait in ms, at least 1
     * @return the message; null if the board has nothing to report
     * @throws PortTimeoutException if a message was due and has not come, or if the board gave no sign of life
     */
    @Throws(PortException::class)
    fun listen(timeoutMs: Int): BoardMessage?

    /**
     * Asks for a message and waits for it. Not called if the board [speaks unasked][speaksUnasked].
     *
     * @param text returns the request; called when the request goes out
     * @param timeoutMs the time limit for the answer in ms, at least 1
     * @param intervalMs milliseconds between requests
     * @throws PortTimeoutException if no answer came
     */
    @Throws(PortException::class)
    fun request(text: () -> String, timeoutMs: Int, intervalMs: Int): BoardMessage =
        throw UnsupportedOperationException("$port speaks unasked")

    /** Checks that the far end is still there. Does not wait for it. */
    @Throws(PortException::class)
    fun check()

    /** Waits up to [timeoutMs] ms for the board's reports, and passes them to the listener of [onBoardEvents]. */
    @Throws(PortException::class)
    fun watch(timeoutMs: Int) = check()

    /**
     * Asks the board for the kinds of its percepts, and waits up to [timeoutMs] ms. Returns an empty list if the board describes none.
     *
     * @throws PortTimeoutException if no answer came
     */
    @Throws(PortException::class)
    fun perceptKinds(timeoutMs: Int): List<PerceptKind> = emptyList()

    /** Returns true if the board answers the command [text]. The outcome of [send] is then an [Answer]. */
    fun answers(text: String): Boolean = false

    /** Sends [text] as a command. Does not wait. */
    fun send(text: String, options: SendOptions): SentCommand

    /** Sends a command that changes the board's critical rules. Does not wait. Only for boards that have reported room for rules. */
    fun sendRule(rule: CommandItem.Rule, options: SendOptions): SentCommand = throw UnsupportedOperationException("$port holds no rules")

    /** Sends [text] as a command and waits for its outcome. Returns the answer; null if the far end does not answer this command. */
    @Throws(PortException::class)
    fun sendAndAwait(text: String, options: SendOptions): Answer?

    /**
     * Writes queued commands on the calling thread until the link is closed. Returns at once if the link needs no thread for its commands.
     */
    @Throws(PortException::class)
    fun writeCommandsUntilClosed() = Unit

    /** Sets the listener for the board's reports. Only boards that can hold rules send reports. */
    fun onBoardEvents(listener: BoardListener) = Unit

    /** Announces [close]. Another opening of the port then waits until the port is free. Does not wait itself. */
    fun leave() = Unit

    /** Closes the link. Further calls have no effect. */
    override fun close()
}

/**
 * An agent's wishes for a board. Immutable.
 *
 * @property isSensed whether the agent perceives the board
 * @property intervalMs the sensing interval in ms; 0 means as fast as possible
 * @property filter the filter of the percepts; null if all percepts are kept
 */
class Wish(val isSensed: Boolean, val intervalMs: Int, val filter: PerceptionFilter?)

/**
 * A message of a board. Immutable.
 *
 * @property text the message's percepts, each with its `;`
 * @property receivedNanos the time at which the message's last byte arrived, by the platform's clock
 * @property seenNanos the percepts that are older than the message, each with its own time, by the platform's clock
 * @property event the percept in [text] that the agent must perceive, in order, even if newer messages have come. If the property is null,
 * the message has no event. If it is empty, the message marks the gap between two equal events
 */
class BoardMessage(
    val text: String,
    val receivedNanos: Long,
    val seenNanos: Map<String, Long> = emptyMap(),
    val event: String? = null,
)

/**
 * A command that a link has accepted. A thread that holds no lock completes each future once, with a [PortException] after a failure.
 *
 * @property outcome completed when the outcome is known; with an [Answer] if the far end [answers][BoardLink.answers] the command
 * @property left completed when the command has reached the board, no later than [outcome]. The agent gets no new snapshot before. [left]
 * is a separate future if the outcome may take long, such as a robot's journey
 * @property giveUp ends the command early: withdraws it, or tells the far end to stop. Does not wait. [giveUp] is null if neither is
 * possible
 */
class SentCommand(
    val outcome: CompletableFuture<*>,
    val left: CompletableFuture<*> = outcome,
    val giveUp: (() -> Unit)? = null,
)

/**
 * The answer of a board to a command. Immutable.
 *
 * @property text the answer as the text of a term; null if there is no text
 * @property why the reason, in words, why [text] is null; null if there is a text
 */
class Answer private constructor(val text: String?, val why: String?) {
    companion object {
        fun of(text: String) = Answer(text, null)

        fun none(why: String) = Answer(null, why)
    }
}
