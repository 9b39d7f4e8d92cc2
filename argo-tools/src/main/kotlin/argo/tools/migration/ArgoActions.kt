package argo.tools.migration

/** The internal actions of ARGO, and the forms in which programs call them. */
internal object ArgoActions {
    /** Their names, without a dot. */
    val NAMES = setOf("port", "limit", "percepts", "act", "age", "change_filter", "explain")

    /** Names that exist behind a dot only. */
    val DOT_NAMES = NAMES + "filter"

    /** The actions that need `argo.Arch`. */
    val OF_BOARDS = setOf("port", "limit", "percepts", "act", "age")

    /** The name in a call of ARGO's actions, as in `.argo.port`, in any case; null for other actions. The action need not [exist][exists]. */
    fun actionIn(called: String): String? {
        val name = called.removePrefix(".")
        return when {
            name.startsWith("argo.", ignoreCase = true) -> name.substringAfter('.')
            called != name && name.lowercase() in DOT_NAMES -> name
            else -> null
        }
    }

    /** Whether Jason finds an internal action under the name [called]. */
    fun exists(called: String): Boolean = called.removePrefix(".argo.").removePrefix(".") in DOT_NAMES || called.removePrefix("argo.") in NAMES
}
