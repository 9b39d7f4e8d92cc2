package argo.observing

/**
 * The infrastructure of a system with agents on several computers. Each agent's last architecture implements this interface. Any thread may
 * use it.
 */
interface SeveralComputers {
    /** The computers that this computer knows, in the order of their names. */
    val computers: List<ObservedComputer>
}

/**
 * A computer with agents of the system.
 *
 * @property address the host name or address of the computer; if it is not known, the computer's name
 * @property isHere whether this program runs on the computer
 * @property isNear whether a browser on this machine can open the computer's live views. True for this computer, and for an address of the
 * loopback interface
 * @property isOn whether the computer is connected with this one
 * @property agents the computer's agents, in the order of their names; empty if it is not connected, or has no agents
 */
data class ObservedComputer(
    val name: String, val address: String, val isHere: Boolean, val isNear: Boolean, val isOn: Boolean, val agents: List<AgentThere>,
)

/**
 * An agent on a computer.
 *
 * @property viewPort the port of the agent's live view on the loopback interface of its computer; null if there is no view or no fixed port
 */
data class AgentThere(val name: String, val viewPort: Int?)
