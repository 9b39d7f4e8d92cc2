package samples.board

import javino.Frame

/** Splits a sketch's message into percepts, each with its `;`; text behind the last `;` is kept unchanged. */
internal fun perceptsOf(said: String): List<String> = said.split(BEHIND_SEMICOLON).filter { it.isNotEmpty() }

private val BEHIND_SEMICOLON = Regex("(?<=;)")

/** Puts [percepts] into as few messages as can hold them, at least one; none is cut in two. */
internal fun messages(percepts: List<String>): List<String> = percepts.fold(listOf("")) { messages, percept ->
    if (messages.last().length + percept.length > Frame.MAX_PAYLOAD) messages + percept
    else messages.dropLast(1) + (messages.last() + percept)
}
