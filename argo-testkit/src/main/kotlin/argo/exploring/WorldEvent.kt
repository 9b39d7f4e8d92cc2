package argo.exploring

import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds

/**
 * An event in the outside world during a run. Immutable. A run depends only on the agents' programs, the description of the boards, and a
 * list of these events.
 *
 * Times are whole milliseconds since the run began. If several events overlap on one board, only the strongest has an effect.
 */
sealed interface WorldEvent {
    /** The time in the run at which the event begins. */
    val at: Duration

    /** The event's end; equal to [at] if the event takes no time. */
    val ends: Duration get() = at

    /** A description without the time. */
    val words: String
}

/** The sensor called [sensor] of the board on port [board] shows [percept] from now on. If [percept] is empty, it shows no percept. */
data class Reads(override val at: Duration, val board: String, val sensor: String, val percept: String) : WorldEvent {
    override val words get() = "the board on $board shows ${percept.ifEmpty { "nothing in place of $sensor" }}"
}

/** For [lasts], the sensor called [sensor] alternates between [percept] and [other], once in [every]. Then its former percept returns. */
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

/** The board on port [board] neither answers nor acts for [lasts]. The board then continues with the bytes that have arrived. */
data class Hangs(override val at: Duration, val board: String, val lasts: Duration) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "the board on $board hangs for $lasts"
}

/** The board on port [board] answers no request for percepts for [lasts], but carries out commands. */
data class IgnoresRequests(override val at: Duration, val board: String, val lasts: Duration) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "the board on $board answers no requests for $lasts, though it takes commands"
}

/** The board on port [board] delays its answers to requests for percepts by the time [by], for [lasts]. */
data class AnswersLate(override val at: Duration, val board: String, val by: Duration, val lasts: Duration) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "the board on $board answers $by late, for $lasts"
}

/** The board on port [board] restarts, and loses bytes that arrive within [booting]. The port stays open. */
data class Restarts(override val at: Duration, val board: String, val booting: Duration) : WorldEvent {
    override val ends get() = at + booting
    override val words get() = "the board on $board restarts, which takes it $booting"
}

/** For [lasts], one in [oneIn] bytes on the line of port [board] arrives with a wrong bit, in both directions. */
data class Garbles(override val at: Duration, val board: String, val oneIn: Int, val lasts: Duration) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "one in $oneIn bytes on the line of $board is wrong, for $lasts"
}

/** The board on port [board] sends its percepts [messages] times without a request, 5 ms apart. */
data class Floods(override val at: Duration, val board: String, val messages: Int) : WorldEvent {
    override val ends get() = at + FLOOD_INTERVAL * messages
    override val words get() = "the board on $board sends ${if (messages == 1) "a message" else "$messages messages"} that nobody asked for"
}

/** The agent [agent] receives a message from [sender], an agent outside of the run. */
data class Hears(
    override val at: Duration,
    val agent: String,
    val sender: String,
    val performative: String,
    val content: String,
) : WorldEvent {
    override val words get() = "$sender sends $agent: $performative $content"
}

/** Messages that other agents send to [agent] within [lasts] are delayed by the time [by], so later ones can overtake them. */
data class MessagesLate(override val at: Duration, val agent: String, val by: Duration, val lasts: Duration) : WorldEvent {
    override val ends get() = at + lasts
    override val words get() = "messages to $agent take $by, for $lasts"
}

internal val FLOOD_INTERVAL = 5.milliseconds
