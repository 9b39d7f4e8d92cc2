package argo.connecting

import argo.links.BoardLink
import jason.asSyntax.Term
import java.util.concurrent.ConcurrentHashMap

/**
 * A port that an agent holds open. Safe for use by several threads.
 *
 * @param names the agent's terms for the port, each with the name that the transport opens
 * @property link the line to its board
 * @property openedNanos the time at which it was opened, by the platform's clock
 * @property losses the number of times in a row that it was lost soon after it had been opened
 * @param use makes the user of the port, which is closed with it
 */
internal class OpenPort(
    names: Map<Term, String>,
    val link: BoardLink,
    options: PortOptions,
    val openedNanos: Long,
    val losses: Int,
    use: (OpenPort) -> AutoCloseable,
) {
    /** The options with which the port was opened. */
    @Volatile
    var options: PortOptions = options
        private set

    private val namesByTerm = ConcurrentHashMap(names)
    private val user = use(this)

    /** The agent's terms for the port, each with the name that the transport opens: a device may have several names. */
    val names: Map<Term, String> get() = namesByTerm

    /** The agent's terms for the port. */
    val terms: Set<Term> get() = namesByTerm.keys

    /** True if a message has come from the board. */
    @Volatile
    var hasSpoken = false

    /** Adds a [term] of the agent for the port, and the [name] that the transport opens. */
    fun addName(term: Term, name: String) {
        namesByTerm[term] = name
    }

    /** Changes the namespace of the board's percepts to [namespace]; null: the default one. */
    fun renamed(namespace: String?) {
        options = options.copy(namespace = namespace)
    }

    /** Closes the link, then its user. Closing a link takes as long as its transport does. May be called twice and by any thread. */
    fun close() {
        link.close()
        user.close()
    }
}

/** The user of an agent's ports. */
internal interface PortUser {
    /** Makes the user of [port]; it starts nothing before [opened], and is closed with the port. */
    fun use(port: OpenPort): AutoCloseable

    /** Notes that [port] is open and belongs to the agent. Called by the thread that opened it. */
    fun opened(port: OpenPort)

    /**
     * Notes that the ports in use have changed: to others, to none, or to the same devices opened anew. Called by the thread that changed
     * them.
     */
    fun portInUseChanged()
}
