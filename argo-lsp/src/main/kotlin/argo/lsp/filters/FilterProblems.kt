package argo.lsp.filters

import argo.check.syntax.Lines
import argo.check.syntax.Position
import argo.check.syntax.Span
import argo.filters.FilterException
import argo.filters.PerceptionFilter
import argo.filters.Problem
import argo.filters.matching.warnings
import argo.lsp.text.Text
import org.eclipse.lsp4j.Diagnostic
import org.eclipse.lsp4j.DiagnosticSeverity

/** Returns the reasons for which [read] refuses [text], or the parts of the filter that have no effect. */
internal fun problemsOf(text: Text, read: (String, String) -> PerceptionFilter): List<Diagnostic> = try {
    val firstLine = Span(0, text.content.substringBefore('\n').length)
    read(text.content, text.uri).warnings().map { diagnostic(text, firstLine, it, DiagnosticSeverity.Warning) }
} catch (refused: FilterException) {
    refused.problems.map { diagnostic(text, spanOf(it, text.content), it.message, DiagnosticSeverity.Error) }
}

private fun diagnostic(text: Text, span: Span, message: String, severity: DiagnosticSeverity) =
    Diagnostic(text.range(span), message, severity, "argo")

/** Returns the span from a problem's place, which is one character, to the end of the word or tag there. */
private fun spanOf(problem: Problem, content: String): Span {
    val begin = Lines(content).offset(Position(problem.line, problem.column))
    val end = (begin + 1..content.length).find { it == content.length || content[it] in ENDS } ?: begin
    return Span(begin, end)
}

private const val ENDS = "<>\"',{}[]\n\r"
