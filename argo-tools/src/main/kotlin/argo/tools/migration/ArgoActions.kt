package argo.tools.migration

/** The internal actions of ARGO, and the forms in which programs call them. */
internal object ArgoActions {
    /** Their names, without a dot. */
    val NAMES = setOf("port", "limit", "percepts", "act", "age", "change_filter", "explain")

    /** Names that exist behind a dot only. */
    val DOT_NAMES = NAMES + "filter"

    /** The actions that need `argo.Arch`. */
    val OF_BOARDS = setOf("port", "limit", "percepts", "act", "age")

    /** The action that [called] means, as in `.argo.port`; null if it is none of ARGO. It need not exist. */
    fun actionIn(called: String): String? = when {
        called.startsWith(".argo.") -> called.removePrefix(".argo.")
        called.startsWith("argo.") -> called.removePrefix("argo.")
        called.startsWith(".") && called.drop(1) in DOT_NAMES -> called.drop(1)
        else -> null
    }

    /** Whether [called] can be called so. */
    fun exists(called: String): Boolean = called.removePrefix(".argo.").removePrefix(".") in DOT_NAMES || called.removePrefix("argo.") in NAMES
}
