package samples.board

import javino.Frame

/** The behaviour of a simulated board's firmware: percepts and actions. Only the board's thread calls it. */
interface Sketch {
    /** The board's actions, all without arguments; empty: the board does not describe them. */
    val actions: List<String> get() = emptyList()

    /** Returns the percepts now, as the board sends them: each followed by `;`, of at most 255 bytes. */
    fun percepts(): String

    /** Returns the percepts now, for the rules on the board; called every few milliseconds while there are rules. */
    fun sensors(): String = percepts()

    /** Executes [command], the text that the agent sent. An unknown command changes nothing. */
    fun act(command: String)
}

/** Splits a sketch's message into percepts, each with its `;`; text behind the last `;` is kept unchanged. */
internal fun perceptsOf(said: String): List<String> = said.split(BEHIND_SEMICOLON).filter { it.isNotEmpty() }

private val BEHIND_SEMICOLON = Regex("(?<=;)")

/** Puts [percepts] into as few messages as can hold them, at least one; none is cut in two. */
internal fun messages(percepts: List<String>): List<String> = percepts.fold(listOf("")) { messages, percept ->
    if (messages.last().length + percept.length > Frame.MAX_PAYLOAD) messages + percept
    else messages.dropLast(1) + (messages.last() + percept)
}
