package argo.check.project

import java.nio.file.Path
import kotlin.io.path.extension

/**
 * The files of a multi-agent system, and the known percepts and actions of its robot.
 *
 * @property programs the programs, by absolute path
 * @property foreignNames words in files of other languages that may be names of beliefs, goals or actions
 * @property operations the part of [foreignNames] that looks like actions or beliefs: strings and artifact operations
 * @property javaActions the internal actions whose classes the project contains, such as `my.act`
 * @property leftOut files that could not be read, with the reasons
 * @property projectFiles the project files of Jason, JaCaMo and Gradle
 */
data class Project(
    val root: Path,
    val programs: Map<Path, AgentProgram>,
    val projectFiles: List<ProjectFile>,
    val foreignNames: Set<String>,
    val operations: Set<String>,
    val javaActions: Set<String>,
    val hasOwnJava: Boolean,
    val filters: List<FilterFile>,
    val robot: Robot,
    val perceptFiles: List<ProjectFile>,
    val leftOut: Map<Path, String>,
) {
    val masFiles: List<MasFile> = projectFiles.filterIsInstance<MasFile>()

    private val included: Map<Path, List<Path?>> = programs.mapValues { (path, program) -> program.includes.map { resolve(path, it) } }

    /**
     * Returns this project with the text [text] in the file at the absolute [path], a program, a `.mas2j`, or an XML or JSON file, which
     * need not be a filter. An editor uses it for unsaved changes. If the project already has this text, returns the project itself.
     */
    fun with(path: Path, text: String): Project = when (path.extension) {
        "asl" -> if (programs[path]?.program?.text == text) this else copy(programs = programs + (path to AgentProgram(path, text)))
        "mas2j" -> if (projectFiles.any { it.path == path && it.text == text }) this
        else copy(projectFiles = projectFiles.filter { it.path != path } + MasFile(path, text))
        "xml", "json" -> if (filters.any { it.path == path && it.text == text }) this else withFilter(path, text)
        else -> this
    }

    private fun withFilter(path: Path, text: String): Project {
        val others = filters.filter { it.path != path }
        return when {
            isFilter(path, text) -> copy(filters = others + FilterFile.of(path, text))
            others.size < filters.size -> copy(filters = others)
            else -> this
        }
    }

    /** Returns true if the file at [path] with this [text] is a filter. Folder, content and the programs' calls decide. */
    private fun isFilter(path: Path, text: String): Boolean =
        FilterFile.isMeant(path, text, programs.values.flatMap { it.filtersCalled }.toSet())

    /** Returns the agents that use the program [path] directly or by an include. */
    fun agentsOf(path: Path): List<MasAgent> =
        masFiles.flatMap { mas -> mas.agents.filter { path in closure(sourceOf(mas, it) ?: return@filter false) } }

    /** Returns the path of an agent's program, or null if the project does not have it. */
    fun sourceOf(mas: MasFile, agent: MasAgent): Path? {
        val folder = mas.path.toAbsolutePath().parent
        val places = listOf(folder) + mas.sourcePaths.map(folder::resolve) + DEFAULT_SOURCES.map(folder::resolve)
        return places.map { it.resolve(agent.source).normalize() }.firstOrNull { it in programs }
            ?: programs.keys.singleOrNull { it.fileName.toString() == agent.source.substringAfterLast('/') }
    }

    /** Returns the program [path] and all programs that one agent may use together with it. */
    fun partsOf(path: Path): Parts {
        val roots = programs.keys.filter { path in closure(it) }
        val all = roots.flatMap { closure(it) }.toSet() + path
        return Parts(all.mapNotNull(programs::get), all.any { null in included[it].orEmpty() })
    }

    private val closures = HashMap<Path, Set<Path>>()

    private fun closure(path: Path): Set<Path> = synchronized(closures) {
        closures.getOrPut(path) {
            val reached = LinkedHashSet<Path>()
            val waiting = ArrayDeque(listOf(path))
            while (waiting.isNotEmpty()) {
                val next = waiting.removeFirst()
                if (reached.add(next)) waiting += included[next].orEmpty().filterNotNull()
            }
            reached
        }
    }

    private fun resolve(from: Path, written: String): Path? {
        if ('$' in written || ':' in written) return null
        val folder = from.toAbsolutePath().parent
        val others = masFiles.flatMap { mas ->
            (mas.sourcePaths + DEFAULT_SOURCES + "").map { mas.path.toAbsolutePath().parent.resolve(it) }
        }
        return (listOf(folder) + others).map { it.resolve(written).normalize() }.firstOrNull { it in programs }
    }

    private companion object {
        val DEFAULT_SOURCES = listOf("src/asl", "src/agt", "asl", "src")
    }
}

/** @property isOpen true if an included file is missing */
class Parts(val programs: List<AgentProgram>, val isOpen: Boolean)
