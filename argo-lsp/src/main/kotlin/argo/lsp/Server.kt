package argo.lsp

import argo.lsp.text.OpenTexts
import org.eclipse.lsp4j.DidChangeConfigurationParams
import org.eclipse.lsp4j.DidChangeWatchedFilesParams
import org.eclipse.lsp4j.InitializeParams
import org.eclipse.lsp4j.InitializeResult
import org.eclipse.lsp4j.MessageParams
import org.eclipse.lsp4j.MessageType
import org.eclipse.lsp4j.ServerInfo
import org.eclipse.lsp4j.SetTraceParams
import org.eclipse.lsp4j.services.LanguageClient
import org.eclipse.lsp4j.services.LanguageClientAware
import org.eclipse.lsp4j.services.LanguageServer
import org.eclipse.lsp4j.services.TextDocumentService
import org.eclipse.lsp4j.services.WorkspaceService
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ExecutionException
import java.util.concurrent.Future
import java.util.concurrent.ScheduledThreadPoolExecutor
import java.util.concurrent.TimeUnit

/**
 * The server of one editor. One thread reads the editor's messages and changes the texts. Another thread, the worker, answers requests and
 * searches for findings.
 */
internal class Server : LanguageServer, LanguageClientAware, AutoCloseable {
    private val worker = ScheduledThreadPoolExecutor(1) { Thread(it, "argo-lsp-worker").apply { isDaemon = true } }
        .apply { removeOnCancelPolicy = true }
    private val texts = OpenTexts()
    private val languages = Languages(texts, ::warn)
    private val diagnostics =
        Diagnostics(texts, worker, languages::diagnostics, languages::rehearse, { client.publishDiagnostics(it) }, ::report)
    private val documents = Documents(texts, worker, languages, diagnostics, ::warn)
    private val workspace = object : WorkspaceService {
        override fun didChangeWatchedFiles(parameters: DidChangeWatchedFilesParams) {
            worker.execute { languages.filesChanged() }
            diagnostics.changed()
        }

        override fun didChangeConfiguration(parameters: DidChangeConfigurationParams) = Unit
    }
    private val end = CompletableFuture<Int>()
    private lateinit var client: LanguageClient

    @Volatile
    private var isShutDown = false

    override fun connect(client: LanguageClient) {
        this.client = client
    }

    override fun initialize(parameters: InitializeParams): CompletableFuture<InitializeResult> {
        languages.hasSnippets = parameters.capabilities?.textDocument?.completion?.completionItem?.snippetSupport == true
        val version = Server::class.java.`package`.implementationVersion
        return CompletableFuture.completedFuture(InitializeResult(CAPABILITIES, ServerInfo("argo", version)))
    }

    override fun shutdown(): CompletableFuture<Any?> {
        isShutDown = true
        return CompletableFuture.completedFuture(null)
    }

    override fun exit() {
        end.complete(if (isShutDown) 0 else 1)
    }

    override fun setTrace(parameters: SetTraceParams) = Unit

    override fun getTextDocumentService(): TextDocumentService = documents

    override fun getWorkspaceService(): WorkspaceService = workspace

    /** Waits until the editor ends this server or closes the connection, which ends [listening]. Returns the exit status. */
    fun awaitEnd(listening: Future<Void>): Int {
        Thread({
            try {
                listening.get()
            } catch (broken: ExecutionException) {
                System.err.println("the editor cannot be read any more: ${broken.cause}")
            }
            end.complete(1)
        }, "argo-lsp-end").apply { isDaemon = true }.start()
        return end.get()
    }

    override fun close() {
        worker.shutdownNow()
        worker.awaitTermination(1, TimeUnit.SECONDS) // lets the last messages reach the editor
    }

    private fun warn(line: String) = client.showMessage(MessageParams(MessageType.Warning, line))

    private fun report(failure: Throwable) {
        client.logMessage(MessageParams(MessageType.Error, "what is wrong could not be found: ${failure.stackTraceToString()}"))
    }
}
