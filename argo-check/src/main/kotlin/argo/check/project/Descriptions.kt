package argo.check.project

import argo.check.syntax.Position
import argo.check.syntax.Span
import javino.PerceptKind
import kotlin.io.path.name

/**
 * A word at [span] of [file], and the word's [meaning]. [isObserved] is true if a board has sent the word. The board may also send others.
 */
class Described<out T>(val meaning: T, val file: ProjectFile, val span: Span, val isObserved: Boolean = false)

/** A part of [file] that is no valid description of a percept, and the [reason]. */
class Unreadable(val file: ProjectFile, val span: Span, val reason: String) {
    override fun toString(): String = "${file.path.name}: $reason"
}

internal class Descriptions(private val file: ProjectFile) {
    private val read = ArrayList<Described<PerceptKind>>()
    private val refused = ArrayList<Unreadable>()

    val percepts: List<Described<PerceptKind>> get() = read
    val unreadable: List<Unreadable> get() = refused

    /** Reads the text at [span] as the description of one percept. */
    fun add(span: Span, isObserved: Boolean = false) {
        try {
            read += Described(PerceptKind.parse(file.text.substring(span.start, span.end)), file, span, isObserved)
        } catch (reason: IllegalArgumentException) {
            refused += Unreadable(file, span, reason.message.orEmpty())
        }
    }
}

/** Reads a percept file. Each line describes one percept, and `#` begins a comment. The comment `# observed` marks an observed percept. */
internal fun perceptsFile(file: ProjectFile): Descriptions = Descriptions(file).apply {
    for (line in 1..file.lines.count) {
        val text = file.lines.text(line)
        val kind = text.substringBefore('#')
        val start = file.lines.offset(Position(line, 1)) + (kind.length - kind.trimStart().length)
        if (kind.isNotBlank()) add(Span(start, start + kind.trim().length), text.substringAfter('#', "").trim() == OBSERVED)
    }
}

private const val OBSERVED = "observed"

/** The percepts and actions that a sketch or a Python program registers in the Javino library. */
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
        /** Matches the macro `F("…")`, which keeps a string of a sketch in flash memory. */
        const val IN_FLASH = "\\s*(?:F\\s*\\(\\s*)?"
        const val NAME = "$IN_FLASH[\"'](\\w+)[\"']\\s*\\)?"
        const val FUNCTION = "(?:\\s*,\\s*[a-zA-Z_]\\w*)?"
        const val NUMBER = "(?:\\s*,\\s*(?:arguments\\s*=\\s*)?(\\d+))?"
        val STRING = Regex("\"([^\"\n]*)\"")
        val DESCRIBED = Regex("\\bdescribe\\s*\\($IN_FLASH\"([^\"\n]*)\"")

        /** Matches a Python call of `perceive`. The descriptions are the arguments behind the function. */
        val PERCEIVED = Regex("\\bperceive\\s*\\((?:[^()\"]++|\"[^\"\n]*+\")*+")
        val ACT = Regex("\\.act\\s*\\[$NAME\\s*]\\s*=")
        val ON_ACTION = Regex("\\b(?:onAction|on_action)\\s*\\($NAME(?:$FUNCTION$NUMBER\\s*\\))?")
    }
}
