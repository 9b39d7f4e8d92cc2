package argo.check.findings

import argo.check.syntax.Program

private val IGNORE = Regex("\\bargo: *ignore\\b")

/**
 * Returns the lines whose findings are hidden. A comment `argo: ignore` hides the findings in its own line, and also those in the next line
 * if the comment stands alone in its line.
 */
internal fun ignoredLines(program: Program): Set<Int> =
    program.comments().filter { (_, text) -> IGNORE.containsMatchIn(text) }.flatMap { (line, text) ->
        if (program.lines.text(line).trim() == text.trim()) listOf(line, line + 1) else listOf(line)
    }.toSet()
