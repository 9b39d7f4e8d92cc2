package argo.filters.format

import argo.filters.FilterException
import argo.filters.FilterNotFoundException
import argo.filters.FilterProvider
import argo.filters.PerceptionFilter
import argo.filters.nameProblem
import java.nio.file.Path

/**
 * Finds filters by name. The finder searches the [FilterProvider]s on the class path of [classLoader] first. It then searches the files in
 * each of [projectDirectories] and in its folder `filters/`, and last the folder `filters/` on the class path. Safe for use by several
 * threads at once.
 *
 * Files are XML (`.xml`) or JSON (`.json`). A name may omit this ending; an XML file is then preferred. A name may contain folders
 * (`night/dark`). A name that leads out of the searched places is refused: absolute paths, `..`, backslashes, and links to files outside.
 */
class FilterFinder(projectDirectories: List<Path>, classLoader: ClassLoader) {
    private val places: List<FilterPlace> =
        listOf(ProvidedFilters(classLoader)) + projectDirectories.flatMap(::placesOf) + FilterResources(classLoader, FOLDER)

    /** Searches in a single project directory. */
    constructor(projectDirectory: Path, classLoader: ClassLoader) : this(listOf(projectDirectory), classLoader)

    private fun placesOf(project: Path) = listOf(
        FilterDirectory(project, project, foreignFiles = true),
        FilterDirectory(project.resolve(FOLDER), project, foreignFiles = false),
    )

    /**
     * Returns the filter called [name]. Each call reads the filter again.
     *
     * @throws FilterNotFoundException if there is no such filter, or several providers offer it; the message lists the searched places and
     *   the existing filters
     * @throws FilterException if its text is refused
     * @throws java.io.IOException if its file cannot be read
     * @throws java.util.ServiceConfigurationError if a provider or one of its filters cannot be made
     */
    fun find(name: String): PerceptionFilter {
        requireInside(name)
        return places.firstNotNullOfOrNull { it.find(name) } ?: throw FilterNotFoundException(notFound(name))
    }

    /**
     * Returns the names of all filters that [find] may find, sorted. Places that cannot be listed are left out. [find] may refuse a listed
     * file because it is no filter.
     *
     * @throws java.util.ServiceConfigurationError if a provider or one of its filters cannot be made
     */
    fun names(): List<String> = places.flatMap(FilterPlace::names).filter { nameProblem(it) == null }.distinct().sorted()

    /** Returns the file on the disk that [find] reads for [name]; null: there is no such file. */
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
