package argo.check.rules

import argo.check.findings.Finding
import argo.check.findings.Level
import argo.check.findings.Place
import argo.check.project.Project
import argo.check.syntax.Position

internal object PerceptFileRules {
    fun check(project: Project): List<Finding> = lines(project) + project.leftOut.map { (file, why) ->
        Finding("left-out", Level.WARNING, Place(file, Position(1, 1), Position(1, 1)), "this is not checked: $why",
            "its names are not known", "make it a readable file, or smaller")
    }

    private fun lines(project: Project): List<Finding> = project.robot.unreadable.filter { it.file in project.perceptFiles }.map {
        Finding("percepts-file", Level.ERROR, it.file.place(it.span), it.reason, "this line is left out", "correct it")
    }
}
