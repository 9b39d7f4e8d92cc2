package argo.lsp.filters

import argo.check.syntax.Span
import argo.lsp.text.Text
import org.eclipse.lsp4j.CompletionItem
import org.eclipse.lsp4j.CompletionItemKind
import org.eclipse.lsp4j.Hover
import org.eclipse.lsp4j.MarkupContent
import org.eclipse.lsp4j.MarkupKind
import org.eclipse.lsp4j.TextEdit
import org.eclipse.lsp4j.jsonrpc.messages.Either

/** The words of a project's boards for filters: functors of [percepts], with their meanings in Markdown, and names of [actions]. */
internal class FilterWords(val percepts: Map<String, String>, val actions: List<String>)

internal fun completion(word: String, kind: CompletionItemKind, meaning: String, text: Text, span: Span) = CompletionItem(word).apply {
    this.kind = kind
    if (meaning.isNotEmpty()) documentation = Either.forRight(MarkupContent(MarkupKind.MARKDOWN, meaning))
    textEdit = Either.forLeft(TextEdit(text.range(span), word))
}

internal fun hoverOf(named: Named) = Hover(MarkupContent(MarkupKind.MARKDOWN, "`${named.name}`\n\n${named.documentation}"))

/** Returns the end of the word that contains [offset] or ends there. */
internal fun endOfWord(content: String, offset: Int): Int =
    (offset until content.length).find { !content[it].isLetterOrDigit() && content[it] !in "_-" } ?: content.length
