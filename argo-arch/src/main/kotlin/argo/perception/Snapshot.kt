package argo.perception

import argo.filters.CriticalPercept
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
 * @property receivedNanos when its last byte came, by the platform's clock
 */
internal class Snapshot(
    val port: OpenPort?,
    val texts: List<String>,
    val kept: List<String>,
    val filterVersion: Long,
    val percepts: List<Literal>,
    val receivedNanos: Long,
    val critical: List<CriticalPercept<Literal>> = emptyList(),
)
