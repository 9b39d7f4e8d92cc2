package argo.exploring

import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds

/**
 * An event in the outside world during a run. Immutable. A run depends only on the programs of agents, the boards, and a list of these
 * events.
 *
 * Times are whole milliseconds from the start of the run. If several events overlap on one board, only the strongest has an effect.
 */
sealed interface WorldEvent {
    /** The start of the event. */
    val at: Duration

    /** The end of the event. An event that takes no time ends at [at]. */
    val ends: Duration get() = at

    /** A description without the time. */
    val words: String
}

/** The sensor [sensor] of the board on port [board] shows [percept] from now on. If [percept] is empty, the sensor shows no percept. */
data class Reads(override val at: Duration, val board: String, val sensor: String, val percept: String) : WorldEvent {
    override val words get() = "the board on $board shows ${percept.ifEmpty { "nothing in place of $sensor" }}"
}

/**
 * The sensor [sensor] alternates between [percept] and [other] for [lasts], with one change in [every]. After [lasts], the sensor shows its
 * former percept again.
 */
data class Flickers(
    override val at: Duration,
    val board: String,
    val sensor: String,
    val percept: String,
    val other: String,
    val every: Duration,
    val lasts: Duration,
) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "the board on $board shows ${shown(percept)} and ${shown(other)} in turn, each for $every, during $lasts"

    private fun shown(text: String) = text.ifEmpty { "nothing" }
}

/** The cable of the board on port [board] is unplugged for [lasts]. The board has no power during that time. */
data class Unplugged(override val at: Duration, val board: String, val lasts: Duration) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "the cable of $board is pulled, and back after $lasts"
}

/** The board on port [board] neither answers nor acts for the time [lasts]. The board then continues with the bytes that have arrived. */
data class Hangs(override val at: Duration, val board: String, val lasts: Duration) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "the board on $board hangs for $lasts"
}

/** The board on port [board] does not answer requests for percepts for the time [lasts]. The board still carries out commands. */
data class IgnoresRequests(override val at: Duration, val board: String, val lasts: Duration) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "the board on $board answers no requests for $lasts, though it takes commands"
}

/** The board on port [board] delays its answers to requests for percepts by [by], for the time [lasts]. */
data class AnswersLate(override val at: Duration, val board: String, val by: Duration, val lasts: Duration) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "the board on $board answers $by late, for $lasts"
}

/** The board on port [board] restarts. The board loses bytes that arrive within [booting]. The port stays open. */
data class Restarts(override val at: Duration, val board: String, val booting: Duration) : WorldEvent {
    override val ends get() = at + booting
    override val words get() = "the board on $board restarts, which takes it $booting"
}

/** One in [oneIn] bytes on the line of port [board] arrives with a wrong bit, in both directions, for the time [lasts]. */
data class Garbles(override val at: Duration, val board: String, val oneIn: Int, val lasts: Duration) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "one in $oneIn bytes on the line of $board is wrong, for $lasts"
}

/** The board on port [board] sends its percepts [messages] times without requests, 5 ms apart. */
data class Floods(override val at: Duration, val board: String, val messages: Int) : WorldEvent {
    override val ends get() = at + FLOOD_INTERVAL * messages
    override val words get() = "the board on $board sends ${if (messages == 1) "a message" else "$messages messages"} that nobody asked for"
}

/** The agent [agent] receives a message from [sender], which is no agent of the run. */
data class Hears(
    override val at: Duration,
    val agent: String,
    val sender: String,
    val performative: String,
    val content: String,
) : WorldEvent {
    override val words get() = "$sender sends $agent: $performative $content"
}

/** Messages from other agents to [agent] are delayed by [by], for the time [lasts]. Later messages can overtake them. */
data class MessagesLate(override val at: Duration, val agent: String, val by: Duration, val lasts: Duration) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "messages to $agent take $by, for $lasts"
}

internal val FLOOD_INTERVAL = 5.milliseconds
