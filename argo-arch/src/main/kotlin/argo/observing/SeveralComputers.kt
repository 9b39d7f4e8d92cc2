package argo.observing

/**
 * The infrastructure of a system with agents on several computers, seen from one agent: the last of its architectures. Any thread may use
 * it.
 */
interface SeveralComputers {
    /** The computers as far as this one knows, in the order of their names. */
    val computers: List<ObservedComputer>
}

/**
 * A computer with agents of the system.
 *
 * @property isHere whether this program runs on the computer
 * @property isOn whether the computer is in touch
 * @property agents the computer's agents, in the order of their names; empty: it is not in touch, or has none
 */
data class ObservedComputer(val name: String, val isHere: Boolean, val isOn: Boolean, val agents: List<AgentThere>)

/**
 * An agent on a computer.
 *
 * @property viewPort the port of the agent's live view, which listens on its computer's loopback interface; null: no view, or no fixed port
 */
data class AgentThere(val name: String, val viewPort: Int?)
