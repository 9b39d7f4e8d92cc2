package argo.filters

import java.nio.file.Path

/**
 * Finds filters by name: in the files of [projectDirectory], in those of `filters/` under it and in `filters/` on the class path of
 * [classLoader], in this order.
 *
 * A name may hold folders (`night/dark`) and `.xml` may be left off. It may not lead out of those places: no absolute paths, no `..`, no
 * backslashes, no links that end elsewhere.
 */
class FilterFinder(projectDirectory: Path, classLoader: ClassLoader) {
    private val places = listOf(
        FilterDirectory(projectDirectory, projectDirectory, foreignFiles = true),
        FilterDirectory(projectDirectory.resolve(FOLDER), projectDirectory, foreignFiles = false),
        FilterResources(classLoader, FOLDER),
    )

    /**
     * The filter called [name], read anew at each call.
     *
     * @throws FilterNotFoundException if there is none; the message says where it was looked for and which filters there are
     * @throws FilterException if its text is refused
     * @throws java.io.IOException if its file cannot be read
     */
    fun find(name: String): PerceptionFilter {
        val bare = name.removeSuffix(EXTENSION)
        requireInside(name, bare)
        return places.firstNotNullOfOrNull { it.find(bare) } ?: throw FilterNotFoundException(notFound(name))
    }

    private fun requireInside(name: String, bare: String) {
        val problem = when {
            bare.isBlank() -> "it is empty"
            bare.any { it == '\\' || it.isISOControl() } -> "it holds a backslash or a control character"
            bare.startsWith('/') || DRIVE.matchesAt(bare, 0) -> "it is an absolute path"
            bare.split('/').any { it.isEmpty() || it == "." || it == ".." } -> "it holds '..', '.' or nothing between slashes"
            else -> return
        }
        throw FilterNotFoundException("'$name' cannot be a filter's name: $problem. ${existing()}")
    }

    private fun notFound(name: String) =
        "There is no filter '$name'. It was looked for in ${places.joinToString(", ")}. ${existing()}"

    private fun existing(): String {
        val names = places.flatMap(FilterPlace::names).distinct().sorted()
        return if (names.isEmpty()) "There are no filters in these places." else "There are these filters: ${names.joinToString(", ")}."
    }

    internal companion object {
        const val EXTENSION = ".xml"
        private const val FOLDER = "filters"
        private val DRIVE = Regex("[A-Za-z]:")
    }
}
