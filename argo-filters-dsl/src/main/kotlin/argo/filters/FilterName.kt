package argo.filters

/** What file names cannot hold on one system or another. */
private const val FOREIGN = "\\:*?\"<>|"

/** What `argo.change_filter` takes for no filter at all. */
private const val NO_FILTER = "none"

/** Why no filter or file of one can have this [name], null if it can. */
internal fun nameProblem(name: String): String? = when {
    name.isBlank() -> "it is empty"
    name.any { it in FOREIGN || it.isISOControl() } -> "it holds a control character or one of $FOREIGN"
    name.startsWith('/') -> "it is an absolute path"
    name.split('/').any { it.isEmpty() || it == "." || it == ".." } -> "it holds '..', '.' or nothing between slashes"
    else -> null
}

/** [name], by which an agent can ask for a filter; others are refused. */
internal fun usableName(name: String): String {
    val problem = if (name == NO_FILTER) "argo.change_filter(none) ends the filtering" else nameProblem(name)
    require(problem == null) { "'$name' cannot be a filter's name: $problem" }
    return name
}
