package argo.lsp

import argo.lsp.language.Language
import argo.lsp.language.RefusedException
import argo.lsp.text.OpenTexts
import argo.lsp.text.Text
import org.eclipse.lsp4j.CompletionItem
import org.eclipse.lsp4j.CompletionList
import org.eclipse.lsp4j.CompletionParams
import org.eclipse.lsp4j.DefinitionParams
import org.eclipse.lsp4j.DidChangeTextDocumentParams
import org.eclipse.lsp4j.DidCloseTextDocumentParams
import org.eclipse.lsp4j.DidOpenTextDocumentParams
import org.eclipse.lsp4j.DidSaveTextDocumentParams
import org.eclipse.lsp4j.DocumentFormattingParams
import org.eclipse.lsp4j.DocumentSymbol
import org.eclipse.lsp4j.DocumentSymbolParams
import org.eclipse.lsp4j.Hover
import org.eclipse.lsp4j.HoverParams
import org.eclipse.lsp4j.Location
import org.eclipse.lsp4j.LocationLink
import org.eclipse.lsp4j.PrepareRenameDefaultBehavior
import org.eclipse.lsp4j.PrepareRenameParams
import org.eclipse.lsp4j.PrepareRenameResult
import org.eclipse.lsp4j.Range
import org.eclipse.lsp4j.ReferenceParams
import org.eclipse.lsp4j.RenameParams
import org.eclipse.lsp4j.SymbolInformation
import org.eclipse.lsp4j.TextDocumentPositionParams
import org.eclipse.lsp4j.TextEdit
import org.eclipse.lsp4j.WorkspaceEdit
import org.eclipse.lsp4j.jsonrpc.CompletableFutures
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException
import org.eclipse.lsp4j.jsonrpc.messages.Either
import org.eclipse.lsp4j.jsonrpc.messages.Either3
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode
import org.eclipse.lsp4j.services.TextDocumentService
import java.util.concurrent.CompletableFuture
import java.util.concurrent.Executor

/** Receives the editor's texts, changes and requests. The [worker] answers a request for the text as it was when the request came. */
internal class Documents(
    private val texts: OpenTexts,
    private val worker: Executor,
    private val languages: Languages,
    private val diagnostics: Diagnostics,
    private val notify: (String) -> Unit,
) : TextDocumentService {
    override fun didOpen(parameters: DidOpenTextDocumentParams) {
        val opened = parameters.textDocument
        texts.open(Text(opened.uri, opened.version, opened.text))
        diagnostics.changed()
    }

    override fun didChange(parameters: DidChangeTextDocumentParams) {
        texts.change(parameters.textDocument.uri, parameters.textDocument.version, parameters.contentChanges)
        diagnostics.changed()
    }

    override fun didClose(parameters: DidCloseTextDocumentParams) {
        texts.close(parameters.textDocument.uri)
        worker.execute { languages.filesChanged() } // unsaved changes of the closed text are gone
        diagnostics.closed(parameters.textDocument.uri)
    }

    override fun didSave(parameters: DidSaveTextDocumentParams) {
        worker.execute { languages.filesChanged() }
        diagnostics.changed()
    }

    override fun completion(parameters: CompletionParams): CompletableFuture<Either<List<CompletionItem>, CompletionList>> =
        answer(parameters.textDocument.uri, Either.forLeft(emptyList())) { text ->
            Either.forLeft(completions(text, text.offset(parameters.position)))
        }

    override fun hover(parameters: HoverParams): CompletableFuture<Hover?> =
        at(parameters, null) { text, offset -> hover(text, offset) }

    override fun definition(parameters: DefinitionParams): CompletableFuture<Either<List<Location>, List<LocationLink>>> =
        at(parameters, Either.forLeft(emptyList())) { text, offset -> Either.forLeft(definitions(text, offset)) }

    override fun references(parameters: ReferenceParams): CompletableFuture<List<Location>> =
        at(parameters, emptyList()) { text, offset -> references(text, offset, parameters.context.isIncludeDeclaration) }

    override fun documentSymbol(parameters: DocumentSymbolParams): CompletableFuture<List<Either<SymbolInformation, DocumentSymbol>>> =
        answer(parameters.textDocument.uri, emptyList()) { text -> symbols(text).map { Either.forRight(it) } }

    override fun formatting(parameters: DocumentFormattingParams): CompletableFuture<List<TextEdit>> =
        answer(parameters.textDocument.uri, emptyList()) { text -> layout(text) }

    override fun prepareRename(
        parameters: PrepareRenameParams,
    ): CompletableFuture<Either3<Range, PrepareRenameResult, PrepareRenameDefaultBehavior>?> =
        at(parameters, null) { text, offset -> refusing { renamed(text, offset) }?.let { Either3.forFirst(it) } }

    override fun rename(parameters: RenameParams): CompletableFuture<WorkspaceEdit?> = at(parameters, null) { text, offset ->
        val renamed = refusing { rename(text, offset, parameters.newName) }
        renamed?.note?.let(notify)
        renamed?.edit
    }

    /** Turns a refusal into an error of the request. The editor shows the message of the error. */
    private fun <T> refusing(work: () -> T): T = try {
        work()
    } catch (refused: RefusedException) {
        throw ResponseErrorException(ResponseError(ResponseErrorCode.RequestFailed, refused.message, null))
    }

    private fun <T> at(parameters: TextDocumentPositionParams, none: T, find: Language.(Text, Int) -> T): CompletableFuture<T> =
        answer(parameters.textDocument.uri, none) { text -> find(text, text.offset(parameters.position)) }

    /** Answers with the result of [find] for the editor's current text, or with [none] if the text or its language is unknown. */
    private fun <T> answer(uri: String, none: T, find: Language.(Text) -> T): CompletableFuture<T> {
        val text = texts[uri]
        val language = languages.of(uri)
        if (text == null || language == null) return CompletableFuture.completedFuture(none)
        return CompletableFutures.computeAsync(worker) { cancel ->
            cancel.checkCanceled()
            language.find(text)
        }
    }
}
