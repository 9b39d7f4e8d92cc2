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
 * @property address the host name or address at which the computer is found; if that is not known, its name
 * @property isHere whether this program runs on the computer
 * @property isNear whether the computer is this program's machine, whose live views a browser here can open: it is this one, or its address
 * is of the loopback interface
 * @property isOn whether the computer is in touch
 * @property agents the computer's agents, in the order of their names; empty: it is not in touch, or has none
 */
data class ObservedComputer(
    val name: String, val address: String, val isHere: Boolean, val isNear: Boolean, val isOn: Boolean, val agents: List<AgentThere>,
)

/**
 * An agent on a computer.
 *
 * @property viewPort the port of the agent's live view, which listens on its computer's loopback interface; null: no view, or no fixed port
 */
data class AgentThere(val name: String, val viewPort: Int?)
