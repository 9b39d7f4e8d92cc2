package argo.lsp.language

import argo.check.syntax.Span
import argo.lsp.text.Text
import org.eclipse.lsp4j.CompletionItem
import org.eclipse.lsp4j.CompletionItemKind
import org.eclipse.lsp4j.MarkupContent
import org.eclipse.lsp4j.MarkupKind
import org.eclipse.lsp4j.TextEdit
import org.eclipse.lsp4j.jsonrpc.messages.Either

internal fun markdown(page: String) = MarkupContent(MarkupKind.MARKDOWN, page)

/** Offers [word] as a replacement of [span] in [text]. [meaning] is in Markdown, or empty if no meaning is known. */
internal fun completion(word: String, kind: CompletionItemKind, meaning: String, text: Text, span: Span) = CompletionItem(word).apply {
    this.kind = kind
    if (meaning.isNotEmpty()) documentation = Either.forRight(markdown(meaning))
    textEdit = Either.forLeft(TextEdit(text.range(span), word))
}
