package argo.connecting

import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** The state of a port in an agent's beliefs, such as `port(ttyACM0,on)`. */
internal enum class PortStatus(val word: String) {
    /** The port is open, and no error or timeout has followed the last answer. */
    ON("on"),

    /** The port is not open, since opening failed or its device has gone. */
    OFF("off"),

    /** The port is open, but the board did not answer in time. */
    TIMEOUT("timeout");

    companion object {
        val WORDS: Set<String> = entries.map { it.word }.toSet()
    }
}

/**
 * The states of an agent's ports, believed as `port(P,on)`, `port(P,off)` or `port(P,timeout)`. Safe for use by several threads.
 *
 * @param changed called after each change, without a lock, with the port, its new state, and the reason or null
 */
internal class PortStates(private val changed: (Term, PortStatus, String?) -> Unit) {
    private val lock = ReentrantLock()
    private val states = LinkedHashMap<String, Pair<Term, PortStatus>>()
    private var version = 0L
    private var believedVersion = 0L

    /**
     * Sets the state of [port], the agent's term for a port. [reason] is for the log.
     *
     * @param isHeld returns true if the agent still has the port. If false, the state is not set. So a port that [clear] has removed stays
     * removed
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

    /** Returns true if a state has changed since the last call of [beliefs]. */
    fun hasNews(): Boolean = lock.withLock { version != believedVersion }

    fun all(): List<Pair<Term, PortStatus>> = lock.withLock { states.values.toList() }

    /** Returns the state of the port that has one of [names]; null if it is not known. */
    fun statusOf(names: Collection<Term>): PortStatus? = lock.withLock { names.firstNotNullOfOrNull { states["$it"]?.second } }

    fun beliefs(): List<Literal> = lock.withLock {
        believedVersion = version
        states.values.map { (port, status) -> ASSyntax.createLiteral("port", port, ASSyntax.createAtom(status.word)) }
    }
}
