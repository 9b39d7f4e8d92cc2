package argo.tools.project

/**
 * The name of a project and of its folder. [id] is the name for Jason and Arduino. [id] has `_` in place of `-`, and a lower-case first
 * letter.
 */
internal data class ProjectName(val name: String) {
    val id: String get() = name.replace('-', '_').replaceFirstChar(Char::lowercase)

    companion object {
        private const val MAX_LENGTH = 60
        private val PATTERN = Regex("[A-Za-z][A-Za-z0-9_-]*")

        /** Reserved Windows names, and keywords of Jason project files. */
        private val TAKEN = setOf("con", "prn", "aux", "nul") + (1..9).flatMap { listOf("com$it", "lpt$it") } +
            setOf("agents", "environment", "infrastructure", "mas")

        fun problem(name: String): String? = when {
            !PATTERN.matches(name) -> "a project's name begins with a letter and has ASCII letters, digits, - and _, unlike \"$name\""
            name.length > MAX_LENGTH -> "a project's name has at most $MAX_LENGTH characters, not ${name.length}"
            name.lowercase() in TAKEN -> "\"$name\" is reserved by Windows or Jason; choose another name"
            else -> null
        }
    }
}
