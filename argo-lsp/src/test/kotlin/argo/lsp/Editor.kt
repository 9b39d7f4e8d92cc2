package argo.lsp

import org.eclipse.lsp4j.CompletionItem
import org.eclipse.lsp4j.CompletionParams
import org.eclipse.lsp4j.DefinitionParams
import org.eclipse.lsp4j.Diagnostic
import org.eclipse.lsp4j.DidChangeTextDocumentParams
import org.eclipse.lsp4j.DidCloseTextDocumentParams
import org.eclipse.lsp4j.DidOpenTextDocumentParams
import org.eclipse.lsp4j.DocumentFormattingParams
import org.eclipse.lsp4j.DocumentSymbol
import org.eclipse.lsp4j.DocumentSymbolParams
import org.eclipse.lsp4j.FormattingOptions
import org.eclipse.lsp4j.HoverParams
import org.eclipse.lsp4j.InitializeParams
import org.eclipse.lsp4j.InitializeResult
import org.eclipse.lsp4j.Location
import org.eclipse.lsp4j.MessageActionItem
import org.eclipse.lsp4j.MessageParams
import org.eclipse.lsp4j.Position
import org.eclipse.lsp4j.PublishDiagnosticsParams
import org.eclipse.lsp4j.Range
import org.eclipse.lsp4j.ReferenceContext
import org.eclipse.lsp4j.ReferenceParams
import org.eclipse.lsp4j.RenameParams
import org.eclipse.lsp4j.ShowMessageRequestParams
import org.eclipse.lsp4j.TextDocumentContentChangeEvent
import org.eclipse.lsp4j.TextDocumentIdentifier
import org.eclipse.lsp4j.TextDocumentItem
import org.eclipse.lsp4j.TextEdit
import org.eclipse.lsp4j.VersionedTextDocumentIdentifier
import org.eclipse.lsp4j.launch.LSPLauncher
import org.eclipse.lsp4j.services.LanguageClient
import org.eclipse.lsp4j.services.LanguageServer
import org.eclipse.lsp4j.services.TextDocumentService
import java.io.PipedInputStream
import java.io.PipedOutputStream
import java.util.concurrent.CompletableFuture
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit

/** An editor for tests. Pipes connect it with a server in this program. */
internal class Editor : AutoCloseable, LanguageClient {
    private val toServer = PipedOutputStream()
    private val toEditor = PipedOutputStream()
    private val server = Server()
    private val published = LinkedBlockingQueue<PublishDiagnosticsParams>()
    private val texts = HashMap<String, Pair<Int, String>>()

    /** The newest diagnostics that the server has published, by the URI. */
    private val said = HashMap<String, PublishDiagnosticsParams>()

    /** The server's messages about itself. */
    val messages = LinkedBlockingQueue<String>()

    val remote: LanguageServer

    init {
        val input = PipedInputStream(toServer, PIPE)
        val launcher = LSPLauncher.createServerLauncher(server, input, toEditor)
        server.connect(launcher.remoteProxy)
        val client = LSPLauncher.createClientLauncher(this, PipedInputStream(toEditor, PIPE), toServer)
        launcher.startListening()
        client.startListening()
        remote = client.remoteProxy
    }

    val capabilities: InitializeResult = remote.initialize(InitializeParams()).get(LIMIT, TimeUnit.SECONDS)

    fun open(uri: String, text: String) {
        texts[uri] = 1 to text
        remote.textDocumentService.didOpen(DidOpenTextDocumentParams(TextDocumentItem(uri, "any", 1, text)))
    }

    /** Replaces the characters from [begin] to [end] by [text]. */
    fun replace(uri: String, begin: Int, end: Int, text: String) {
        val (version, before) = texts.getValue(uri)
        val change = TextDocumentContentChangeEvent(Range(position(before, begin), position(before, end)), text)
        texts[uri] = version + 1 to before.replaceRange(begin, end, text)
        remote.textDocumentService.didChange(DidChangeTextDocumentParams(VersionedTextDocumentIdentifier(uri, version + 1), listOf(change)))
    }

    fun text(uri: String): String = texts.getValue(uri).second

    fun version(uri: String): Int = texts.getValue(uri).first

    /** Returns the diagnostics of the current text of [uri]. Waits until the server has published them. */
    fun lastDiagnostics(uri: String): List<Diagnostic> {
        said[uri]?.takeIf { it.version == version(uri) }?.let { return it.diagnostics }
        return diagnostics(uri)
    }

    fun close(uri: String) {
        texts -= uri
        remote.textDocumentService.didClose(DidCloseTextDocumentParams(TextDocumentIdentifier(uri)))
    }

    /** Waits for the next diagnostics of the current text of [uri]. */
    fun diagnostics(uri: String): List<Diagnostic> {
        while (true) {
            val next = published.poll(LIMIT, TimeUnit.SECONDS)
            checkNotNull(next) { "nothing was said about $uri in $LIMIT s; ${messages.toList()}" }
            said[next.uri] = next
            if (next.uri == uri && next.version == texts[uri]?.first) return next.diagnostics
        }
    }

    /** Returns all published diagnostics that no call has taken. */
    fun publications(): List<PublishDiagnosticsParams> = ArrayList<PublishDiagnosticsParams>().also { taken ->
        published.drainTo(taken)
        taken.forEach { said[it.uri] = it }
    }

    fun completions(uri: String, offset: Int): List<CompletionItem> =
        at(uri, offset).let { (file, place) -> ask { it.completion(CompletionParams(file, place)) }.left }

    fun hover(uri: String, offset: Int): String? =
        at(uri, offset).let { (file, place) -> ask { it.hover(HoverParams(file, place)) }?.contents?.right?.value }

    private fun <T> ask(request: (TextDocumentService) -> CompletableFuture<T>): T =
        request(remote.textDocumentService).get(LIMIT, TimeUnit.SECONDS)

    private fun at(uri: String, offset: Int) = TextDocumentIdentifier(uri) to position(text(uri), offset)

    fun definitions(uri: String, offset: Int): List<Location> =
        at(uri, offset).let { (file, place) -> ask { it.definition(DefinitionParams(file, place)) }.left.toList() }

    fun references(uri: String, offset: Int): List<Location> =
        at(uri, offset).let { (file, place) -> ask { it.references(ReferenceParams(file, place, ReferenceContext(true))) }.toList() }

    fun rename(uri: String, offset: Int, name: String): Map<String, List<TextEdit>> =
        at(uri, offset).let { (file, place) -> ask { it.rename(RenameParams(file, place, name)) }?.changes.orEmpty() }

    fun outline(uri: String): List<DocumentSymbol> =
        ask { it.documentSymbol(DocumentSymbolParams(TextDocumentIdentifier(uri))) }.map { it.right }

    fun layout(uri: String): List<TextEdit> =
        ask { it.formatting(DocumentFormattingParams(TextDocumentIdentifier(uri), FormattingOptions(4, true))) }.toList()

    override fun close() {
        toServer.close()
        server.close()
        toEditor.close()
    }

    override fun publishDiagnostics(diagnostics: PublishDiagnosticsParams) {
        published += diagnostics
    }

    override fun logMessage(message: MessageParams) {
        messages += message.message
    }

    override fun showMessage(message: MessageParams) {
        messages += message.message
    }

    override fun telemetryEvent(event: Any?) = Unit

    override fun showMessageRequest(request: ShowMessageRequestParams): CompletableFuture<MessageActionItem?> =
        CompletableFuture.completedFuture(null)

    private companion object {
        const val LIMIT = 60L
        const val PIPE = 1 shl 20
    }
}

/** Returns the position of [offset] in [text]. Between `\r` and `\n`, returns the position of the line's end. */
internal fun position(text: String, offset: Int): Position {
    val at = if (offset < text.length && text[offset] == '\n' && offset > 0 && text[offset - 1] == '\r') offset - 1 else offset
    val lines = text.substring(0, at).split("\r\n", "\n", "\r")
    return Position(lines.lastIndex, lines.last().length)
}

/** Returns [offset], or the offset before `\r\n` if [offset] is between both characters. */
internal fun whole(text: String, offset: Int): Int =
    if (offset in 1..<text.length && text[offset] == '\n' && text[offset - 1] == '\r') offset - 1 else offset
