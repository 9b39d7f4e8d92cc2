package argo.check.project

import argo.check.findings.Place
import argo.check.syntax.Lexer
import argo.check.syntax.Lines
import argo.check.syntax.Span
import argo.check.syntax.Token
import argo.check.syntax.TokenKind
import java.nio.file.Path

/** A project file of Jason, JaCaMo (`.jcm`) or Gradle, or a percept file. */
open class ProjectFile(val path: Path, val text: String) {
    val lines: Lines = Lines(text)

    /** The AgentSpeak tokens of the file, without comments. */
    val tokens: List<Token> by lazy { Lexer(text) {}.tokens().filter { it.kind != TokenKind.COMMENT } }

    fun place(span: Span): Place = Place(path, lines.position(span.start), lines.position(span.end))
}
