package argo.check.project

import argo.filters.matching.perceptsOf
import javino.PerceptArgument
import javino.PerceptKind
import javino.PerceptTerm

/**
 * What is known of a robot; each list is empty if nothing is.
 *
 * @property described the kinds of percepts that files describe, with their places
 * @property registered the actions that programs of boards register, with their places
 * @property unreadable the reasons why descriptions of percepts cannot be read, each with the name of its file
 * @property isComplete false if it has percepts besides these
 */
class Robot(
    val described: List<Described<PerceptKind>> = emptyList(),
    val registered: List<Described<BoardAction>> = emptyList(),
    val unreadable: List<String> = emptyList(),
    otherPercepts: List<PerceptKind> = emptyList(),
    otherActions: List<BoardAction> = emptyList(),
    val isComplete: Boolean = true,
) {
    /** The kinds of percepts that its boards have, also those from mappings and recordings. */
    val percepts: List<PerceptKind> = (described.map { it.meaning } + otherPercepts).distinct()

    /** The actions that its boards have registered, also those from mappings. */
    val actions: List<BoardAction> = registered.map { it.meaning } + otherActions
}

/** @property arity the number of its arguments; null: any */
data class BoardAction(val name: String, val arity: Int?) {
    override fun toString(): String = "$name/${arity ?: "*"}"

    companion object {
        /** Reads `speed/1`, or `say` with any number of arguments. */
        fun of(text: String): BoardAction = BoardAction(text.substringBefore('/'), text.substringAfter('/', "").toIntOrNull())
    }
}

/** Returns the kinds of the percepts in a recording of a board: their functors and numbers of arguments; of values nothing is known. */
internal fun recordedKinds(recording: String): List<PerceptKind> {
    val lines = recording.lines().drop(1).map { it.split('\t') }
    val messages = lines.filter { it.size == RECORDED_PARTS && it[1] == "in" }.map { it[2] }.distinct()
    val percepts = messages.flatMap(::perceptsOf).map(PerceptTerm::of).distinctBy { it.indicator() }
    return percepts.filter { NAME.matches(it.functor()) }.map { percept ->
        PerceptKind(percept.functor(), percept.arguments().map { PerceptArgument.Anything() })
    }
}

/** Milliseconds, direction and text. */
private const val RECORDED_PARTS = 3
private val NAME = Regex("~?[a-z][A-Za-z0-9_]*")
