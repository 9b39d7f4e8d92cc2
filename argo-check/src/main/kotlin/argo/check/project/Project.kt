package argo.check.project

import java.nio.file.Path

/**
 * A multi-agent system as its files describe it, and the known percepts and actions of its robot.
 *
 * @property programs the programs, by their absolute paths
 * @property foreignNames words in files of other languages, which may be names of beliefs, goals and actions
 * @property operations those of [foreignNames] that look like actions or beliefs: strings, and operations of artifacts
 * @property javaActions the internal actions whose classes are in the project, such as `my.act`
 * @property leftOut files that were not read, each with the reason
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

    /** Returns this project with [text] in place of the text of the program [path], as for an unsaved change in an editor. */
    fun with(path: Path, text: String): Project =
        copy(programs = programs + (path.toAbsolutePath().normalize() to AgentProgram(path.toAbsolutePath().normalize(), text)))

    /** Returns this project with [text] in place of the text of the file [path], in XML or JSON. The file need not be a filter. */
    fun withFilter(path: Path, text: String): Project {
        val others = filters.filter { it.path != path }
        return when {
            isFilter(path, text) -> copy(filters = others + FilterFile.of(path, text))
            others.size < filters.size -> copy(filters = others)
            else -> this
        }
    }

    /** Returns true if the file at [path] with this [text] is a filter, to judge by its folder, its rules or a program's call. */
    private fun isFilter(path: Path, text: String): Boolean =
        FilterFile.isMeant(path, text, programs.values.flatMap { it.filtersCalled }.toSet())

    /** Returns the agents whose program is [path] or includes [path]. */
    fun agentsOf(path: Path): List<MasAgent> =
        masFiles.flatMap { mas -> mas.agents.filter { path in closure(sourceOf(mas, it) ?: return@filter false) } }

    /** Returns the path of an agent's program; null: the project does not have that program. */
    fun sourceOf(mas: MasFile, agent: MasAgent): Path? {
        val folder = mas.path.toAbsolutePath().parent
        val places = listOf(folder) + mas.sourcePaths.map(folder::resolve) + DEFAULT_SOURCES.map(folder::resolve)
        return places.map { it.resolve(agent.source).normalize() }.firstOrNull { it in programs }
            ?: programs.keys.singleOrNull { it.fileName.toString() == agent.source.substringAfterLast('/') }
    }

    /** Returns the program [path] and all programs that one agent may run together with it. */
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
