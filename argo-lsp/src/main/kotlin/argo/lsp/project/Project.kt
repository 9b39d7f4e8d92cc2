package argo.lsp.project

import argo.check.ProjectCheck
import argo.check.project.AgentProgram
import argo.check.project.Robot
import argo.check.syntax.Program
import argo.lsp.text.Text
import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension

/** The files of a project. A text that is open in the editor replaces its file. [checked] is the project as argo-check reads it. */
internal class Project(
    val checked: argo.check.project.Project,
    private val open: Map<Path, Text>,
    val check: ProjectCheck = ProjectCheck(checked),
) {
    val robot: Robot get() = checked.robot

    val sources: List<Source> by lazy { checked.programs.values.map(::source) }

    val filters: List<Path> get() = checked.filters.map { it.path }

    val filterNames: List<String> get() = filters.map { it.nameWithoutExtension }.distinct().sorted()

    fun sourceOf(text: Text): Source = fileOf(text.uri)?.let(checked.programs::get)?.let { Source(it, text) }
        ?: Source(AgentProgram(Path.of(nameOf(text.uri)), text.content), text)

    /** Returns [source], followed by the other programs of the agents that use [source]. */
    fun family(source: Source): List<Source> =
        listOf(source) + checked.partsOf(source.file).programs.filter { it !== source.agent }.map(::source)

    /** Returns the programs that an include of [name] may mean. */
    fun included(name: String): List<Source> = sources.filter { it.file.endsWith(name.substringAfterLast('/')) }

    private fun source(program: AgentProgram) =
        Source(program, open[program.path] ?: Text(program.path.toUri().toString(), 0, program.program.text))
}

/** A program of a project, with its text in the editor or on the disk. */
internal class Source(val agent: AgentProgram, val text: Text) {
    val file: Path get() = agent.path
    val program: Program get() = agent.program
    val occurrences: List<Occurrence> by lazy { agent.mentions.all.mapNotNull(Occurrence::of) }

    fun occurrenceAt(offset: Int): Occurrence? = occurrences.find { it.name.touches(offset) }
}
