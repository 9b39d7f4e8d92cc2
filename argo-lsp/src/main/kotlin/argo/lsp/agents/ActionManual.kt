package argo.lsp.agents

/** The documentation of ARGO's internal actions and errors, from the pages of docs/ that this module contains. */
internal object ActionManual {
    /** The pages of actions in Markdown, by names such as `argo.act`. */
    val actions: Map<String, String> = page("internal-actions.md").split(Regex("(?m)^## ")).drop(1)
        .associate { section -> section.lineSequence().first() to withoutLinks(section.substringAfter('\n').trim()) }

    /** The options of actions, by the action's name without dots. Each option has its meaning or, if the page has none, its form. */
    val options: Map<String, Map<String, String>> = actions.mapKeys { it.key.removePrefix("argo.") }
        .mapValues { (_, text) -> optionsIn(text) }
        .let { it + ("ports" to it.getValue("port")) }

    /** All causes of each error, by the error's atom. */
    val errors: Map<String, String> = page("errors.md").lines().mapNotNull(ROW::matchEntire)
        .groupBy({ it.groupValues[1] }) { "${it.groupValues[2]}: ${it.groupValues[3]}" }
        .mapValues { (_, causes) -> withoutLinks(causes.joinToString("\n\n")) }

    private fun page(name: String): String =
        checkNotNull(javaClass.getResourceAsStream("/argo/lsp/manual/$name")) { "$name is not in this jar" }
            .use { it.readBytes().decodeToString() }

    private fun optionsIn(text: String): Map<String, String> {
        val list = LIST.find(text)?.groupValues?.get(1) ?: return emptyMap()
        return OPTION.findAll(list).groupBy({ it.groupValues[2] }) { it.groupValues[3].trim().ifEmpty { "`${it.groupValues[1]}`" } }
            .mapValues { (_, meanings) -> meanings.distinct().joinToString("\n\n") }
    }

    /** Removes links, since their targets do not exist in an editor. */
    private fun withoutLinks(text: String) = text.replace(LINK, "$1")
}

private val ROW = Regex("""\| `([a-z_]+)` \| (.+?) \| (.+) \|""")
private val LINK = Regex("""\[([^\]]+)]\([^)]+\)""")

/** Matches the words "list of" and the options after them, in the same sentence or as list items below. */
private val LIST = Regex("""\blist\s+of\s((?:\s*`[a-z]+(?:\([^`]*\))?`(?:,|\s+or)?)+|(?:- (?:.+\n?)+))""")
private val OPTION = Regex("""`(([a-z]+)(?:\([^`]*\))?)`(?:: ((?:.+\n?)(?: .+\n?)*))?""")
