package argo.view.timeline

import kotlinx.serialization.Serializable

/** A row of the timeline of an agent, from top to bottom. */
internal enum class Lane {
    /** The traffic of the line: messages of boards, and commands at the time when they had left or the board had acted. */
    LINE,

    /** The agent's percepts, at the time of the perceiving cycle. */
    PERCEPTS,

    /** The events that the agent chose. */
    EVENTS,

    /** The steps of the agent's intentions. */
    INTENTIONS,

    /** The agent's commands, from their issue to their outcome. */
    COMMANDS,

    /** The lines that the agent printed. */
    PRINTED,
}

/**
 * An item on the timeline of a recorded agent. Immutable.
 *
 * @property id the item's index in [Timeline.items]
 * @property agent the index of its agent in [Timeline.agents]
 * @property from the item's beginning, in seconds since the beginning of the recording
 * @property until the item's end; null if it took no time
 * @property text a short description
 * @property detail the details, one on each line
 * @property isBad whether it is a failure
 * @property causes the ids of its causes
 * @property command the number of the agent's command, from 1; null if the item is no command
 */
@Serializable
internal class Item(
    val id: Int,
    val agent: Int,
    val lane: Lane,
    val from: Double,
    val until: Double? = null,
    val text: String,
    val detail: List<String> = emptyList(),
    val isBad: Boolean = false,
    val causes: List<Int> = emptyList(),
    val command: Long? = null,
) {
    fun causedBy(cause: Int) = Item(id, agent, lane, from, until, text, detail, isBad, causes + cause, command)
}
