package argo.lsp

import org.eclipse.lsp4j.CompletionOptions
import org.eclipse.lsp4j.RenameOptions
import org.eclipse.lsp4j.SaveOptions
import org.eclipse.lsp4j.ServerCapabilities
import org.eclipse.lsp4j.TextDocumentSyncKind
import org.eclipse.lsp4j.TextDocumentSyncOptions
import org.eclipse.lsp4j.jsonrpc.messages.Either

internal val CAPABILITIES = ServerCapabilities().apply {
    textDocumentSync = Either.forRight(
        TextDocumentSyncOptions().apply {
            openClose = true
            change = TextDocumentSyncKind.Incremental
            save = Either.forRight(SaveOptions(false))
        },
    )
    completionProvider = CompletionOptions(false, listOf(".", "!", "+", "-", "?", "<", "\"", "_"))
    setHoverProvider(true)
    setDefinitionProvider(true)
    setReferencesProvider(true)
    setDocumentSymbolProvider(true)
    setDocumentFormattingProvider(true)
    renameProvider = Either.forRight(RenameOptions(true))
}
