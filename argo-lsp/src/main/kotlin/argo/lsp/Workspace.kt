package argo.lsp

import org.eclipse.lsp4j.DidChangeConfigurationParams
import org.eclipse.lsp4j.DidChangeWatchedFilesParams
import org.eclipse.lsp4j.services.WorkspaceService
import java.util.concurrent.Executor

/** Receives the editor's messages about changed files on the disk. */
internal class Workspace(
    private val worker: Executor,
    private val languages: Languages,
    private val diagnostics: Diagnostics,
) : WorkspaceService {
    override fun didChangeWatchedFiles(parameters: DidChangeWatchedFilesParams) {
        worker.execute { languages.filesChanged() }
        diagnostics.changed()
    }

    override fun didChangeConfiguration(parameters: DidChangeConfigurationParams) = Unit
}
