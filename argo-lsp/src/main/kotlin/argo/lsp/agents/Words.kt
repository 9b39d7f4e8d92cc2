package argo.lsp.agents

/**
 * The words that have a meaning in Jason and ARGO. The meanings are in Markdown.
 *
 * @property errors the errors that a plan may match
 * @property options the options of internal actions, by the action's name without dots
 * @property hasSnippets true if the editor treats `${1:X}` in inserted text as a placeholder
 */
internal class Words(
    val actions: Map<String, String>,
    val errors: Map<String, String>,
    val options: Map<String, Map<String, String>>,
    val hasSnippets: Boolean,
) {
    /** Returns the name of the ARGO action that a program can call by [called]; null if [called] is no action of ARGO. */
    fun actionIn(called: String): String? = called.removePrefix(".").removePrefix("argo.")
        .takeIf { (called.startsWith(".") || called.startsWith("argo.")) && "argo.$it" in actions }
}
