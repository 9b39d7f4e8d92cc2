package argo.filters.format

import argo.filters.FilterException
import argo.filters.FilterNotFoundException
import argo.filters.FilterProvider
import argo.filters.PerceptionFilter
import argo.filters.nameProblem
import java.nio.file.Path

/**
 * Finds filters by name. The finder searches the [FilterProvider]s on the class path of [classLoader] first. Then it searches each of
 * [projectDirectories] and its folder `filters/`. Last it searches the folder `filters/` on the class path. Safe for use by several
 * threads at once.
 *
 * Files are XML (`.xml`) or JSON (`.json`). A name may omit this ending. The finder then prefers an XML file. A name may contain folders
 * (`night/dark`). The finder refuses a name that leads out of the searched places: absolute paths, `..`, backslashes, and links to files
 * outside.
 */
class FilterFinder(projectDirectories: List<Path>, classLoader: ClassLoader) {
    private val places: List<FilterPlace> =
        listOf(ProvidedFilters(classLoader)) + projectDirectories.flatMap(::placesOf) + FilterResources(classLoader, FOLDER)

    /** Creates a finder for a single project directory. */
    constructor(projectDirectory: Path, classLoader: ClassLoader) : this(listOf(projectDirectory), classLoader)

    private fun placesOf(project: Path) = listOf(
        FilterDirectory(project, project, foreignFiles = true),
        FilterDirectory(project.resolve(FOLDER), project, foreignFiles = false),
    )

    /**
     * Returns the filter called [name]. Each call reads the filter again.
     *
     * @throws FilterNotFoundException if there is no such filter, or if several providers offer different filters of this name; the
     *     message says which
     * @throws FilterException if the filter's text is refused
     * @throws java.io.IOException if the filter's file cannot be read
     * @throws java.util.ServiceConfigurationError if a provider or one of its filters cannot be made
     */
    fun find(name: String): PerceptionFilter {
        requireInside(name)
        return places.firstNotNullOfOrNull { it.find(name) } ?: throw FilterNotFoundException(notFound(name))
    }

    /**
     * Returns the sorted names of all filters that [find] may find. Leaves out places that cannot be listed. A listed file may turn out
     * to be no filter, and [find] then refuses it.
     *
     * @throws java.util.ServiceConfigurationError if a provider or one of its filters cannot be made
     */
    fun names(): List<String> = places.flatMap(FilterPlace::names).filter { nameProblem(it) == null }.distinct().sorted()

    /** Returns the file on the disk that [find] reads for [name], or null. */
    fun path(name: String): Path? = places.firstNotNullOfOrNull { it.path(name) }

    private fun requireInside(name: String) {
        val problem = nameProblem(FilterFormat.bareName(name)) ?: return
        throw FilterNotFoundException("'$name' cannot be a filter's name: $problem. ${existing()}")
    }

    private fun notFound(name: String) =
        "There is no filter '$name'. It was looked for in ${places.joinToString(", ")}. ${existing()}"

    private fun existing(): String {
        val names = names()
        return if (names.isEmpty()) "There are no filters in these places." else "There are these filters: ${names.joinToString(", ")}."
    }

    private companion object {
        const val FOLDER = "filters"
    }
}
