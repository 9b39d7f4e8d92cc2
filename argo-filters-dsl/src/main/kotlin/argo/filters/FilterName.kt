package argo.filters

/** Characters that file names cannot contain on some systems. */
private const val FOREIGN = "\\:*?\"<>|"

/** The name by which an agent asks for no filter. */
const val NO_FILTER: String = "none"

/** Returns the reason why [name] cannot be the name of a filter and its file; null: it can be. */
internal fun nameProblem(name: String): String? = when {
    name.isBlank() -> "it is empty"
    name == NO_FILTER -> "argo.change_filter($NO_FILTER) ends the filtering"
    name.any { it in FOREIGN || it.isISOControl() } -> "it holds a control character or one of $FOREIGN"
    name.startsWith('/') -> "it is an absolute path"
    name.split('/').any { it.isEmpty() || it == "." || it == ".." } -> "it holds '..', '.' or nothing between slashes"
    else -> null
}

/** Returns [name] if an agent can call a filter by it; throws an [IllegalArgumentException] otherwise. */
internal fun usableName(name: String): String {
    val problem = nameProblem(name)
    require(problem == null) { "'$name' cannot be a filter's name: $problem" }
    return name
}
