package argo.check.project

import javino.PerceptKind
import java.nio.file.Path

/**
 * A multi-agent system as its files say, and what is known of its robot.
 *
 * @property programs the programs, by their absolute paths
 * @property foreignNames words in the project's files in other languages, which may name beliefs, goals and actions
 * @property operations names of [foreignNames] that look like actions or beliefs: strings, and operations of artifacts
 * @property javaActions the internal actions whose classes are in the project, as `my.act`
 * @property leftOut files that were not read, with the reason
 * @property projectFiles the files of Jason, of JaCaMo and of Gradle
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

    /** Returns this project with another text of the program [path], as an editor has it. */
    fun with(path: Path, text: String): Project =
        copy(programs = programs + (path.toAbsolutePath().normalize() to AgentProgram(path.toAbsolutePath().normalize(), text)))

    /** Returns true if the file at [path] with this [text], in XML or JSON, is a filter: its folder, a program or its rules say so. */
    fun isFilter(path: Path, text: String): Boolean =
        FilterFile.isMeant(path, text, programs.values.flatMap { it.filtersCalled }.toSet())

    /** Returns the agents whose program is [path], or includes it. */
    fun agentsOf(path: Path): List<MasAgent> =
        masFiles.flatMap { mas -> mas.agents.filter { path in closure(sourceOf(mas, it) ?: return@filter false) } }

    /** Returns the path of an agent's program; null: it is none of this project's. */
    fun sourceOf(mas: MasFile, agent: MasAgent): Path? {
        val folder = mas.path.toAbsolutePath().parent
        val places = listOf(folder) + mas.sourcePaths.map(folder::resolve) + DEFAULT_SOURCES.map(folder::resolve)
        return places.map { it.resolve(agent.source).normalize() }.firstOrNull { it in programs }
            ?: programs.keys.singleOrNull { it.fileName.toString() == agent.source.substringAfterLast('/') }
    }

    /** Returns the programs that are parts of the same agents as [path], and [path] itself. */
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

/** @property isOpen true if a file that one includes is not there */
class Parts(val programs: List<AgentProgram>, val isOpen: Boolean)
