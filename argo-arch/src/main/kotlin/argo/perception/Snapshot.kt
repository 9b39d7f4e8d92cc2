package argo.perception

import argo.connecting.OpenPort
import argo.filters.matching.CriticalPercept
import argo.observing.PerceivedMessage
import jason.asSyntax.Literal

/**
 * The percepts that reach the agent from one message of a board.
 *
 * @property port the port of the board that sent the message
 * @property texts the percepts as the board sent them
 * @property kept the percepts that the filter lets through, and the percepts that replace held-back ones
 * @property percepts the beliefs that the agent gets from the message
 * @property receivedNanos the time of the message's last byte, by the platform's clock
 * @property critical the percepts that meet critical rules of the filter, once for each rule
 * @property unreadable the percepts in [kept] that the agent cannot believe
 * @property seenNanos returns the time of one of [percepts], by the platform's clock; null if only an older message contained it. If this
 * function is null, all percepts were seen at [receivedNanos]
 * @property event the event among the percepts, see [argo.links.BoardMessage.event]
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
    val event: PerceptEvent? = null,
) : PerceivedMessage {
    override val portName: String get() = port?.link?.port.orEmpty()
    override val namespace: String? get() = port?.options?.namespace

    fun with(event: PerceptEvent) = copy(texts + event.texts, kept + event.texts, percepts + event.percepts, event)

    fun withoutEvent(): Snapshot =
        if (event == null) this else copy(texts - event.texts.toSet(), kept - event.texts.toSet(), percepts - event.percepts.toSet(), null)

    private fun copy(texts: List<String>, kept: List<String>, percepts: List<Literal>, event: PerceptEvent?) =
        Snapshot(port, texts, kept, percepts, receivedNanos, critical, unreadable, seenNanos, event)
}

/** An event, see [argo.links.BoardMessage.event], as texts and as beliefs. If both are empty, it is the gap between two equal events. */
internal class PerceptEvent(val texts: List<String>, val percepts: List<Literal>)
