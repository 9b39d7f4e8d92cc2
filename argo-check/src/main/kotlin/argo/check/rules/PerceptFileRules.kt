package argo.check.rules

import argo.check.findings.Finding
import argo.check.findings.Level
import argo.check.findings.Place
import argo.check.project.Project
import argo.check.project.ProjectFile
import argo.check.syntax.Position
import javino.PerceptKind

/** Lines in files of percepts that describe none, and files that were not read. */
internal object PerceptFileRules {
    fun check(project: Project): List<Finding> = project.perceptFiles.flatMap(::lines) + project.leftOut.map { (file, why) ->
        Finding("left-out", Level.WARNING, Place(file, Position(1, 1), Position(1, 1)), "this is not checked: $why",
            "its names are not known", "make it a readable file, or smaller")
    }

    private fun lines(file: ProjectFile): List<Finding> = (1..file.lines.count).mapNotNull { number ->
        val kind = file.lines.text(number).substringBefore('#').trim()
        val problem = if (kind.isEmpty()) null else problemIn(kind)
        problem?.let { Finding("percepts-file", Level.ERROR, Place(file.path, Position(number, 1), Position(number, kind.length + 1)), it,
            "this line is left out", "correct it") }
    }

    private fun problemIn(kind: String): String? = try {
        PerceptKind.parse(kind)
        null
    } catch (refused: IllegalArgumentException) {
        refused.message
    }
}
