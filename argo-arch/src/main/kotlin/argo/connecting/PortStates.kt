package argo.connecting

import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** The state of a port in an agent's beliefs, as in `port(ttyACM0,on)`. */
internal enum class PortStatus(val word: String) {
    /** Open, and without trouble since the last answer. */
    ON("on"),

    /** Not open: opening failed, or the port's device has gone. */
    OFF("off"),

    /** Open, but the board did not answer in time. */
    TIMEOUT("timeout");

    companion object {
        /** The atoms that can be a port's status. */
        val WORDS: Set<String> = entries.map { it.word }.toSet()
    }
}

/**
 * The states of the ports that an agent has asked for, which it believes as `port(P,on)`, `port(P,off)` or `port(P,timeout)`.
 *
 * Safe for use by several threads.
 *
 * @param changed is called after each change, outside any lock, with the port, its new state and the reason if there is one
 */
internal class PortStates(private val changed: (Term, PortStatus, String?) -> Unit) {
    private val lock = ReentrantLock()
    private val states = LinkedHashMap<String, Pair<Term, PortStatus>>()
    private var version = 0L
    private var believedVersion = 0L

    /**
     * Sets the state of the port that the agent calls [port]; [reason] is for the log.
     *
     * @param isHeld returns true if the port is still the agent's; else no state is set, so a given-up port stays forgotten after [clear]
     */
    fun set(port: Term, status: PortStatus, reason: String? = null, isHeld: () -> Boolean = { true }) {
        val isNew = lock.withLock {
            if (!isHeld()) return
            val before = states.put(port.toString(), port to status)
            (before?.second != status).also { if (it) version++ }
        }
        if (isNew) changed(port, status, reason)
    }

    fun clear() = lock.withLock {
        states.clear()
        version++
    }

    /** Returns true if something has changed since [beliefs] was asked last. */
    fun hasNews(): Boolean = lock.withLock { version != believedVersion }

    /** Returns all ports by the agent's terms, with their states. */
    fun all(): List<Pair<Term, PortStatus>> = lock.withLock { states.values.toList() }

    /** Returns the state of the port that the agent calls by one of [names]; null: it is not known. */
    fun statusOf(names: Collection<Term>): PortStatus? = lock.withLock { names.firstNotNullOfOrNull { states["$it"]?.second } }

    /** Returns the beliefs about all ports. */
    fun beliefs(): List<Literal> = lock.withLock {
        believedVersion = version
        states.values.map { (port, status) -> ASSyntax.createLiteral("port", port, ASSyntax.createAtom(status.word)) }
    }
}
