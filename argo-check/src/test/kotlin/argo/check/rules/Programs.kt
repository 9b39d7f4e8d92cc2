package argo.check.rules

import argo.check.ProjectCheck
import argo.check.findings.Finding
import argo.check.project.Project
import argo.check.project.ProjectReader
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

internal fun projectOf(root: Path, vararg files: Pair<String, String>): Project {
    val folder = Files.createTempDirectory(root, "project")
    files.forEach { (name, text) -> folder.resolve(name).apply { parent.createDirectories() }.writeText(text) }
    return ProjectReader().projectsIn(folder).single()
}

internal fun findingsIn(root: Path, vararg files: Pair<String, String>): List<Finding> = ProjectCheck(projectOf(root, *files)).findings()

/** The finding in one line: `2:5 belief-unknown: dits/2 is awaited and never believed; did you mean dist?` */
internal val Finding.inShort: String get() = "${place.begin} $rule: $what; $remedy"
