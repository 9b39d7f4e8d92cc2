package argo.perception

import argo.connecting.OpenPort
import argo.filters.matching.CriticalPercept
import argo.observing.PerceivedMessage
import jason.asSyntax.Literal

/**
 * The percepts of one message of a board that reach the agent.
 *
 * @property port the port of the board that sent the message
 * @property texts the percepts as they came off the line
 * @property kept the percepts that passed the filter, and stand-ins for percepts that the filter holds back
 * @property percepts the beliefs that the agent gets from the message
 * @property receivedNanos the time of the message's last byte, by the platform's clock
 * @property critical the percepts that meet critical rules of the filter, once for each rule
 * @property unreadable the percepts in [kept] that cannot be believed
 * @property seenNanos returns the time at which one of [percepts] was seen, by the platform's clock; null: only an older message had it.
 * Without this function, all were seen at [receivedNanos]
 * @property isEvent see [argo.links.BoardMessage.isEvent]
 */
internal class Snapshot(
    val port: OpenPort?,
    override val texts: List<String>,
    override val kept: List<String>,
    val percepts: List<Literal>,
    override val receivedNanos: Long,
    val critical: List<CriticalPercept<Literal>> = emptyList(),
    override val unreadable: Set<String> = emptySet(),
    val seenNanos: ((Literal) -> Long?)? = null,
    val isEvent: Boolean = false,
) : PerceivedMessage {
    override val portName: String get() = port?.link?.port.orEmpty()
    override val namespace: String? get() = port?.options?.namespace
}
