package argo.filters

/** Characters that some systems do not allow in file names. */
private const val FOREIGN = "\\:*?\"<>|"

/** The name with which an agent ends the filtering. */
const val NO_FILTER: String = "none"

/**
 * Returns why [name] cannot be the name of a filter and its file. Returns null if [name] is usable. `FilterDirectory` refuses links that
 * lead out of the filters' place.
 */
internal fun nameProblem(name: String): String? = when {
    name.isBlank() -> "it is empty"
    name == NO_FILTER -> "argo.change_filter($NO_FILTER) ends the filtering"
    name.any { it in FOREIGN || it.isISOControl() } -> "it holds a control character or one of $FOREIGN"
    name.startsWith('/') -> "it is an absolute path"
    name.split('/').any { it.isEmpty() || it == "." || it == ".." } -> "it holds '..', '.' or nothing between slashes"
    else -> null
}

/** Returns [name]. Throws an [IllegalArgumentException] if agents cannot call a filter by this name. */
internal fun usableName(name: String): String {
    val problem = nameProblem(name)
    require(problem == null) { "'$name' cannot be a filter's name: $problem" }
    return name
}
