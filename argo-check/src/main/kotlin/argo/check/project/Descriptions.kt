package argo.check.project

import argo.check.syntax.Position
import argo.check.syntax.Span
import javino.PerceptKind

/**
 * A word that a file gives a meaning to.
 *
 * @property span the place in [file]
 */
class Described<out T>(val meaning: T, val file: ProjectFile, val span: Span)

/** A description of percepts that cannot be read, and the reason. */
internal class Unreadable(val file: ProjectFile, val span: Span, val reason: String)

/** The kinds of percepts that a file describes. */
internal class Descriptions(private val file: ProjectFile) {
    private val read = ArrayList<Described<PerceptKind>>()
    private val refused = ArrayList<Unreadable>()

    val percepts: List<Described<PerceptKind>> get() = read
    val unreadable: List<Unreadable> get() = refused

    /** Takes in the part [span] of the file, which should describe a kind. */
    fun add(span: Span) {
        try {
            read += Described(PerceptKind.parse(file.text.substring(span.start, span.end)), file, span)
        } catch (reason: IllegalArgumentException) {
            refused += Unreadable(file, span, reason.message.orEmpty())
        }
    }
}

/** Reads a file of percepts, which has a kind in each line and comments behind `#`. */
internal fun perceptsFile(file: ProjectFile): Descriptions = Descriptions(file).apply {
    for (line in 1..file.lines.count) {
        val kind = file.lines.text(line).substringBefore('#')
        val start = file.lines.offset(Position(line, 1)) + (kind.length - kind.trimStart().length)
        if (kind.isNotBlank()) add(Span(start, start + kind.trim().length))
    }
}

/** What a sketch, or a program in Python, says in calls of the Javino library: the kinds of its percepts, and its actions. */
internal class BoardProgram(private val file: ProjectFile) {
    val descriptions = Descriptions(file).apply {
        DESCRIBED.findAll(file.text).forEach { add(spanOf(it.groups[1]!!.range)) }
        for (call in PERCEIVED.findAll(file.text)) {
            STRING.findAll(file.text.substring(0, call.range.last + 1), call.range.first).forEach { add(spanOf(it.groups[1]!!.range)) }
        }
    }

    val actions: List<Described<BoardAction>> = ACT.findAll(file.text).map { action(it, 0) }.toList() +
        ON_ACTION.findAll(file.text).map { action(it, it.groupValues[2].toIntOrNull()) }

    private fun action(call: MatchResult, arity: Int?) =
        Described(BoardAction(call.groupValues[1], arity), file, spanOf(call.groups[1]!!.range))

    private fun spanOf(range: IntRange) = Span(range.first, range.last + 1)

    private companion object {
        /** A string of a sketch may stand in the macro `F(…)`, which keeps it in flash. */
        const val IN_FLASH = "\\s*(?:F\\s*\\(\\s*)?"
        const val NAME = "$IN_FLASH[\"'](\\w+)[\"']\\s*\\)?"
        const val FUNCTION = "(?:\\s*,\\s*[a-zA-Z_]\\w*)?"
        const val NUMBER = "(?:\\s*,\\s*(?:arguments\\s*=\\s*)?(\\d+))?"
        val STRING = Regex("\"([^\"\n]*)\"")
        val DESCRIBED = Regex("\\bdescribe\\s*\\($IN_FLASH\"([^\"\n]*)\"")

        /** In Python, which takes descriptions behind the function that perceives. */
        val PERCEIVED = Regex("\\bperceive\\s*\\((?:[^()\"]++|\"[^\"\n]*+\")*+")
        val ACT = Regex("\\.act\\s*\\[$NAME\\s*]\\s*=")
        val ON_ACTION = Regex("\\b(?:onAction|on_action)\\s*\\($NAME(?:$FUNCTION$NUMBER\\s*\\))?")
    }
}
