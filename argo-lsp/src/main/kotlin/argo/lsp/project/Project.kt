package argo.lsp.project

import argo.check.project.AgentProgram
import argo.check.project.Robot
import argo.lsp.text.Text
import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension

/**
 * The files of a project, with what the editor has open in place of what is on the disk.
 *
 * @property checked the project as the analyser has it
 */
internal class Project(val checked: argo.check.project.Project, private val open: Map<Path, Text>) {
    val robot: Robot get() = checked.robot

    /** The agents' programs. */
    val sources: List<Source> by lazy { checked.programs.values.map(::source) }

    /** The files of filters. */
    val filters: List<Path> get() = checked.filters.map { it.path }

    val filterNames: List<String> get() = filters.map { it.nameWithoutExtension }.distinct().sorted()

    /** Returns the program in [text]. */
    fun sourceOf(text: Text): Source = fileOf(text.uri)?.let(checked.programs::get)?.let { Source(it, text) }
        ?: Source(AgentProgram(Path.of(text.uri.substringAfterLast('/')), text.content), text)

    /** Returns the programs that are parts of the same agents as [source], itself first. */
    fun family(source: Source): List<Source> =
        listOf(source) + checked.partsOf(source.file).programs.filter { it !== source.agent }.map(::source)

    /** Returns the program of the file that an include writes as [name]. */
    fun included(name: String): List<Source> = sources.filter { it.file.endsWith(name.substringAfterLast('/')) }

    private fun source(program: AgentProgram) =
        Source(program, open[program.path] ?: Text(program.path.toUri().toString(), 0, program.program.text))
}
