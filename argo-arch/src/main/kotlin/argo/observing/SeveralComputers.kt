package argo.observing

/** An agent's infrastructure, the last of its architectures, whose agents are on several computers. Any thread may use it. */
interface SeveralComputers {
    /** The computers as far as this one knows, in the order of their names. */
    val computers: List<ObservedComputer>
}

/**
 * A computer with agents of the system.
 *
 * @property isHere whether this program runs on it
 * @property isOn whether it is in touch
 * @property agents its agents, in the order of their names; empty: it is not in touch, or has none
 */
data class ObservedComputer(val name: String, val isHere: Boolean, val isOn: Boolean, val agents: List<AgentThere>)

/**
 * An agent on a computer.
 *
 * @property viewPort the port of its live view, which listens on the loopback interface of its computer; null: it has none, or any
 */
data class AgentThere(val name: String, val viewPort: Int?)
