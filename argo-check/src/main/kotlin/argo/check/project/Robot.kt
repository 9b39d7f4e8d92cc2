package argo.check.project

import argo.filters.matching.perceptsOf
import javino.PerceptArgument
import javino.PerceptKind
import javino.PerceptTerm

/**
 * What is known of a robot; each list is empty if nothing is.
 *
 * @property percepts the kinds of percepts that its boards have
 * @property actions the actions that its boards have registered
 * @property isComplete false if it has percepts besides these
 */
class Robot(val percepts: List<PerceptKind>, val actions: List<BoardAction>, val isComplete: Boolean = true)

/** @property arity the number of its arguments; null: any */
data class BoardAction(val name: String, val arity: Int?) {
    override fun toString(): String = "$name/${arity ?: "*"}"

    companion object {
        /** Reads `speed/1`, or `say` with any number of arguments. */
        fun of(text: String): BoardAction = BoardAction(text.substringBefore('/'), text.substringAfter('/', "").toIntOrNull())
    }
}

/** What a sketch, or a program in Python, says in calls of the Javino library: the kinds of its percepts, and its actions. */
internal class BoardProgram(private val text: String) {
    val percepts: List<PerceptKind> = (DESCRIBED.findAll(text) + PERCEIVED.findAll(text).flatMap { STRING.findAll(it.value) })
        .map { it.groupValues[1] }.mapNotNull { runCatching { PerceptKind.parse(it) }.getOrNull() }.toList()

    val actions: List<BoardAction> = ACT.findAll(text).map { BoardAction(it.groupValues[1], 0) }.toList() +
        ON_ACTION.findAll(text).map { BoardAction(it.groupValues[1], it.groupValues[2].toIntOrNull()) }

    private companion object {
        val STRING = Regex("\"([^\"\n]*)\"")
        val DESCRIBED = Regex("\\bdescribe\\(\\s*(?:F\\(\\s*)?\"([^\"\n]*)\"")
        val PERCEIVED = Regex("\\bperceive\\([^)\"]*(?:\"[^\"\n]*\"[^)\"]*)+\\)")
        val ACT = Regex("\\.act\\[[\"'](\\w+)[\"']]\\s*=")
        private const val NAME = "[\"'](\\w+)[\"']"
        private const val FUNCTION = "(?:\\s*,\\s*[a-zA-Z_]\\w*)?"
        private const val NUMBER = "(?:\\s*,\\s*(?:arguments\\s*=\\s*)?(\\d+))?"
        val ON_ACTION = Regex("\\b(?:onAction|on_action)\\(\\s*$NAME$FUNCTION$NUMBER\\s*\\)")
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
