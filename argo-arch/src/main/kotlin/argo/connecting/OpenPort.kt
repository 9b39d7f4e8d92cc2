package argo.connecting

import argo.links.BoardLink
import jason.asSyntax.Term
import java.util.concurrent.ConcurrentHashMap

/**
 * A port that an agent holds open. Safe for use by several threads.
 *
 * @param names the terms that the agent calls it by, each with the name that the transport opens
 * @property link the line to its board
 * @property openedNanos when it was opened, by the platform's clock
 * @property losses how often in a row it was lost soon after it had been opened
 * @param use makes what works through the port and is closed with it
 */
internal class OpenPort(
    names: Map<Term, String>,
    val link: BoardLink,
    options: PortOptions,
    val openedNanos: Long,
    val losses: Int,
    use: (OpenPort) -> AutoCloseable,
) {
    /** How it is used. */
    @Volatile
    var options: PortOptions = options
        private set

    private val namesByTerm = ConcurrentHashMap(names)
    private val user = use(this)

    /** The terms that the agent calls it by, each with the name that the transport opens: a device may have several. */
    val names: Map<Term, String> get() = namesByTerm

    /** The terms that the agent calls it by. */
    val terms: Set<Term> get() = namesByTerm.keys

    /** Whether a message has come from the board. */
    @Volatile
    var hasSpoken = false

    /** Adds the term that the agent calls it by, and the [name] that the transport opens. */
    fun addName(term: Term, name: String) {
        namesByTerm[term] = name
    }

    /** What the board says is believed in [namespace] from now on; null: in the default one. */
    fun renamed(namespace: String?) {
        options = options.copy(namespace = namespace)
    }

    /** Closes the link, then its user. Closing a link takes as long as its transport does. May be called twice and by any thread. */
    fun close() {
        link.close()
        user.close()
    }
}

/** What works through the ports of an agent. */
internal interface PortUser {
    /** Makes what works through [port]; it starts nothing before [opened], and is closed with the port. */
    fun use(port: OpenPort): AutoCloseable

    /** [port] is open, and the agent's. Called by the thread that opened it. */
    fun opened(port: OpenPort)

    /**
     * Other ports are in use than before, or none, or the same devices after they were opened again. Called by the thread that changed it.
     */
    fun portInUseChanged()
}
