package argo.tools.project

/**
 * A project's name.
 *
 * @property name as it was given: the folder's name
 * @property id the same as Jason and Arduino can use it, with `_` for `-`, and in lower case at its beginning
 */
internal data class ProjectName(val name: String) {
    val id: String get() = name.replace('-', '_').replaceFirstChar(Char::lowercase)

    companion object {
        private const val LONGEST = 60
        private val PATTERN = Regex("[A-Za-z][A-Za-z0-9_-]*")

        /** What Windows does not let a file be called, and words of Jason's project files. */
        private val TAKEN = setOf("con", "prn", "aux", "nul") + (1..9).flatMap { listOf("com$it", "lpt$it") } +
            setOf("agents", "environment", "infrastructure", "mas")

        /** What is wrong with [name]; null: nothing. */
        fun problem(name: String): String? = when {
            !PATTERN.matches(name) -> "a project's name begins with a letter and has letters of ASCII, digits, - and _, unlike \"$name\""
            name.length > LONGEST -> "a project's name has at most $LONGEST characters, not ${name.length}"
            name.lowercase() in TAKEN -> "\"$name\" means something to Windows or to Jason; another name"
            else -> null
        }
    }
}
