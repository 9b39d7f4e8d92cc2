package argo.check.project

import argo.filters.matching.perceptsOf
import javino.PerceptArgument
import javino.PerceptKind
import javino.PerceptTerm

/**
 * The known percepts and actions of a robot. Lists are empty if nothing is known.
 *
 * @property described the percepts that files describe, with the places of the descriptions
 * @property registered the actions that board programs register, with the places in these programs
 * @property unreadable the invalid descriptions of percepts
 * @property isComplete false if the robot may have other percepts too
 */
class Robot(
    val described: List<Described<PerceptKind>> = emptyList(),
    val registered: List<Described<BoardAction>> = emptyList(),
    val unreadable: List<Unreadable> = emptyList(),
    otherPercepts: List<PerceptKind> = emptyList(),
    otherActions: List<BoardAction> = emptyList(),
    val isComplete: Boolean = true,
) {
    /** All percepts of the boards, including those of mappings and recordings. */
    val percepts: List<PerceptKind> = (described.map { it.meaning } + otherPercepts).distinct()

    /** The percepts that were observed but not described. A percept in this set may also have other values. */
    val observed: Set<PerceptKind> =
        described.filter { it.isObserved }.map { it.meaning }.toSet() - described.filterNot { it.isObserved }.map { it.meaning }.toSet()

    /** All actions of the boards, including those of mappings. */
    val actions: List<BoardAction> = registered.map { it.meaning } + otherActions
}

/** @property arity the number of arguments, or null if it is not fixed */
data class BoardAction(val name: String, val arity: Int?) {
    override fun toString(): String = "$name/${arity ?: "*"}"

    companion object {
        /** Reads `speed/1`, or `say` for any number of arguments. */
        fun of(text: String): BoardAction = BoardAction(text.substringBefore('/'), text.substringAfter('/', "").toIntOrNull())
    }
}

/** Returns the functors and arities of the percepts in the recording of a board. Each percept allows any values. */
internal fun recordedKinds(recording: String): List<PerceptKind> {
    val lines = recording.lines().drop(1).map { it.split('\t') }
    val messages = lines.filter { it.size == RECORDED_PARTS && it[1] == "in" }.map { it[2] }.distinct()
    val percepts = messages.flatMap(::perceptsOf).map(PerceptTerm::of).distinctBy { it.indicator() }
    return percepts.filter { NAME.matches(it.functor()) }.map { percept ->
        PerceptKind(percept.functor(), percept.arguments().map { PerceptArgument.Anything() })
    }
}

/** The number of fields in a recorded line: milliseconds, direction and text. */
private const val RECORDED_PARTS = 3
private val NAME = Regex("~?[a-z][A-Za-z0-9_]*")
