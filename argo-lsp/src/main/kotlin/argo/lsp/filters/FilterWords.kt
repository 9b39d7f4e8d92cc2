package argo.lsp.filters

import argo.lsp.language.markdown
import org.eclipse.lsp4j.Hover

internal const val PREDICATE = "predicate"
internal const val REFLEX = "reflex"

/** Words for filters, from a project's boards: functors of [percepts] with their meanings in Markdown, and names of [actions]. */
internal class FilterWords(val percepts: Map<String, String>, val actions: List<String>)

/** A name that is possible at some place of a filter file, with its meaning in words. [values] is empty if there are too many to list. */
internal class Named(val name: String, val documentation: String, val values: List<String> = emptyList())

internal fun hoverOf(named: Named) = Hover(markdown("`${named.name}`\n\n${named.documentation}"))

/** Returns the end of the word that contains [offset] or ends there. */
internal fun endOfWord(content: String, offset: Int): Int =
    (offset until content.length).find { !content[it].isLetterOrDigit() && content[it] !in "_-" } ?: content.length
