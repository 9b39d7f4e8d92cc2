package argo.tools.check

import argo.check.ProjectCheck
import argo.check.findings.Finding
import argo.check.findings.Level
import argo.check.project.Project
import argo.check.project.ProjectReader
import argo.filters.withControlsShown
import argo.tools.command.DataCommand
import argo.tools.command.ExitStatus
import argo.tools.command.ToolException
import argo.tools.command.counted
import argo.tools.command.jsonArrayOf
import argo.tools.command.jsonOf
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension

@Command(
    name = "check",
    description = [
        "Checks programs in AgentSpeak, project files and filters without running them: misspelt names, wrong arguments, options and " +
            "actions that do not exist, and percepts and commands that the robot does not have.",
        "Exit status 0 whatever it finds, unless --fail-on is given.",
    ],
)
internal class CheckCommand : DataCommand() {
    @Parameters(
        arity = "0..*", paramLabel = "PROJECT", defaultValue = ".",
        description = ["folders, project files or programs; the working directory by default"],
    )
    private lateinit var places: List<Path>

    @Option(names = ["--hints"], description = ["also prints what may be meant"])
    private var hints = false

    @Option(names = ["--sarif"], description = ["prints SARIF 2.1.0, which forges and editors show"])
    private var sarif = false

    @Option(names = ["--fail-on"], paramLabel = "LEVEL",
        description = ["error, warning or hint: exit status 1 if there is a finding of this level or graver"])
    private var failOn: String? = null

    override fun call(): Int {
        val limit = failOn?.let { word ->
            Level.entries.find { it.name.lowercase() == word } ?: misuse("--fail-on is error, warning or hint, not $word")
        }
        if (json && sarif) misuse("--json and --sarif are two forms; give one")
        val checked = places.map(::checked)
        val findings = checked.flatMap { it.second }.distinct()
        val shown = findings.filter { hints || json || sarif || it.level != Level.HINT }
        when {
            json -> out.println(jsonArrayOf(shown.map(::jsonOf)))
            sarif -> out.println(sarifOf(shown))
            else -> print(shown, findings, checked.sumOf { it.first })
        }
        return if (limit != null && findings.any { it.level <= limit }) ExitStatus.FAILED else ExitStatus.DONE
    }

    private fun checked(place: Path): Pair<Int, List<Finding>> {
        if (!Files.exists(place)) throw ToolException("there is no file $place")
        val isFolder = Files.isDirectory(place)
        if (!isFolder && place.extension !in CHECKED) {
            throw ToolException("$place cannot be checked; files that can: ${CHECKED.joinToString { ".$it" }}")
        }
        if (!isFolder && !Files.isRegularFile(place)) throw ToolException("$place is no regular file")
        val projects = ProjectReader().projectsIn(place)
        if (projects.isEmpty()) throw ToolException("$place has no program, .asl, and no project file, .mas2j")
        val findings = projects.flatMap { ProjectCheck(it).findings() }
        val file = place.toAbsolutePath().normalize()
        return if (isFolder || place.extension in PROJECT_FILES) projects.sumOf(::filesOf) to findings
        else 1 to findings.filter { it.place.file.toAbsolutePath().normalize() == file }
    }

    private fun filesOf(project: Project) = project.programs.size + project.projectFiles.size + project.filters.size

    private fun print(shown: List<Finding>, all: List<Finding>, files: Int) {
        for (finding in shown) {
            val level = when (finding.level) {
                Level.ERROR -> paint.bad("error")
                Level.WARNING -> paint.doubtful("warning")
                Level.HINT -> paint.aside("hint")
            }
            val place = "${fileOf(finding)}:${finding.place.begin}"
            out.println("$place: $level: ${withControlsShown(finding.what)} ${paint.aside("[${finding.rule}]")}")
            out.println("    ${withControlsShown("${finding.why}; ${finding.remedy}")}")
        }
        val counts = Level.entries.associateWith { level -> all.count { it.level == level } }
        val unseen = counts.getValue(Level.HINT).takeIf { !hints && it > 0 }?.let { ", which --hints shows" }.orEmpty()
        out.println(
            "${counted(files, "file")} checked: ${counted(counts.getValue(Level.ERROR), "error")}, " +
                "${counted(counts.getValue(Level.WARNING), "warning")}, ${counted(counts.getValue(Level.HINT), "hint")}$unseen",
        )
    }

    private fun jsonOf(finding: Finding) = jsonOf(
        "file" to fileOf(finding), "line" to
            finding.place.begin.line, "column" to finding.place.begin.column, "endLine" to finding.place.end.line,
        "endColumn" to finding.place.end.column, "level" to finding.level.name.lowercase(), "rule" to finding.rule, "what" to finding.what,
        "why" to finding.why, "remedy" to finding.remedy,
    )

    private companion object {
        val PROJECT_FILES = listOf("mas2j", "jcm")
        val CHECKED = listOf("asl") + PROJECT_FILES
    }
}

/** Returns the file of [finding]. A file in the working directory gets a relative path. */
internal fun fileOf(finding: Finding): Path {
    val here = Path.of("").toAbsolutePath()
    val file = finding.place.file.toAbsolutePath().normalize()
    return if (file.startsWith(here)) here.relativize(file) else file
}
