package argo.connecting

import argo.links.BoardLink
import jason.asSyntax.Term
import java.util.concurrent.ConcurrentHashMap

/**
 * A port that an agent holds open. Safe for use by several threads.
 *
 * @param names the agent's terms for the port, each with the name that the transport opens
 * @property link the line to the board
 * @property openedNanos the time at which the port was opened, by the platform's clock
 * @property losses how many times in a row the port was lost soon after its opening
 * @param use creates the user of the port. Closing the port closes its user
 */
internal class OpenPort(
    names: Map<Term, String>,
    val link: BoardLink,
    options: PortOptions,
    val openedNanos: Long,
    val losses: Int,
    use: (OpenPort) -> AutoCloseable,
) {
    @Volatile
    var options: PortOptions = options
        private set

    private val namesByTerm = ConcurrentHashMap(names)
    private val user = use(this)

    /** The agent's terms for the port, each with the name that the transport opens. A device may have several names. */
    val names: Map<Term, String> get() = namesByTerm

    val terms: Set<Term> get() = namesByTerm.keys

    @Volatile
    var hasSpoken = false

    fun addName(term: Term, name: String) {
        namesByTerm[term] = name
    }

    /** Changes the namespace of the board's percepts; null for the default namespace. */
    fun renamed(namespace: String?) {
        options = options.copy(namespace = namespace)
    }

    /** Closes the link, then its user. Waits for the transport. Further calls have no effect. Any thread may call this function. */
    fun close() {
        link.close()
        user.close()
    }
}

internal interface PortUser {
    /** Makes the user of [port]. The user starts its work only at [opened], and is closed with the port. */
    fun use(port: OpenPort): AutoCloseable

    /** Notes that [port] is open and belongs to the agent. Called by the thread that opened it. */
    fun opened(port: OpenPort)

    /**
     * Notes that other ports or no ports are in use, or that devices in use were opened again. Called by the thread that made the change.
     */
    fun portInUseChanged()
}
