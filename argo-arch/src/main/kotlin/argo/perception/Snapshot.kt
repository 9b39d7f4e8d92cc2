package argo.perception

import argo.filters.matching.CriticalPercept
import argo.observing.PerceivedMessage
import argo.ports.OpenPort
import jason.asSyntax.Literal

/**
 * What the sensors said in one message.
 *
 * @property port whose board said it
 * @property texts the percepts as they came off the line
 * @property kept those of them that the filter let through, and what stands for those that it holds back
 * @property filterVersion which of the filters that the agent has chosen so far was active
 * @property percepts what the agent is to believe of it
 * @property critical what of it the filter's critical rules meet, once for each such rule
 * @property unreadable those of [kept] that cannot be believed
 * @property receivedNanos when its last byte came, by the platform's clock
 */
internal class Snapshot(
    val port: OpenPort?,
    override val texts: List<String>,
    override val kept: List<String>,
    val filterVersion: Long,
    val percepts: List<Literal>,
    override val receivedNanos: Long,
    val critical: List<CriticalPercept<Literal>> = emptyList(),
    override val unreadable: Set<String> = emptySet(),
) : PerceivedMessage {
    override val portName: String get() = port?.link?.port().orEmpty()
}
