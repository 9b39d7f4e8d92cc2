package argo.lsp.agents

/**
 * The words that Jason and ARGO give meanings to, with the meanings in Markdown.
 *
 * @property actions the internal actions
 * @property errors the errors that a plan may match
 * @property options the options of internal actions, by the action's name without dots
 * @property hasSnippets whether the editor replaces `${1:X}` in what it inserts
 */
internal class Words(
    val actions: Map<String, String>,
    val errors: Map<String, String>,
    val options: Map<String, Map<String, String>>,
    val hasSnippets: Boolean,
) {
    /** Returns the name of ARGO's action that a program calls [called]; null: it is none of ARGO's. */
    fun actionIn(called: String): String? = called.removePrefix(".").removePrefix("argo.")
        .takeIf { (called.startsWith(".") || called.startsWith("argo.")) && "argo.$it" in actions }
}
