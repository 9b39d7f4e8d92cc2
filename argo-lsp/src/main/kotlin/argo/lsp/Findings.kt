package argo.lsp

import argo.check.findings.Finding
import argo.check.findings.Level
import argo.check.syntax.Position
import argo.lsp.project.Projects
import argo.lsp.project.fileOf
import argo.lsp.text.Text
import org.eclipse.lsp4j.Diagnostic
import org.eclipse.lsp4j.DiagnosticSeverity
import org.eclipse.lsp4j.Range
import org.eclipse.lsp4j.jsonrpc.messages.Either

/** The findings of argo-check, in the editor's form. */
internal class Findings(private val projects: Projects) {
    /** Returns the findings in [text]: a program, a project file or a filter. */
    fun of(text: Text): List<Diagnostic> {
        val project = projects.of(text)
        val found = if (text.uri.endsWith(".asl")) project.check.findingsIn(project.sourceOf(text).agent)
        else project.check.findingsInFiles().filter { it.place.file == fileOf(text.uri) }
        return found.map(::diagnostic)
    }

    private fun diagnostic(finding: Finding) = Diagnostic(
        Range(position(finding.place.begin), position(finding.place.end)), "${finding.what}: ${finding.why}; ${finding.remedy}",
        severityOf(finding.level), "argo",
    ).apply { code = Either.forLeft(finding.rule) }

    private fun position(it: Position) = org.eclipse.lsp4j.Position(it.line - 1, it.column - 1)

    private fun severityOf(level: Level) = when (level) {
        Level.ERROR -> DiagnosticSeverity.Error
        Level.WARNING -> DiagnosticSeverity.Warning
        Level.HINT -> DiagnosticSeverity.Hint
    }
}
