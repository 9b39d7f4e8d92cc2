package argo.lsp.text

import argo.check.syntax.Lines
import argo.check.syntax.Span
import org.eclipse.lsp4j.Position
import org.eclipse.lsp4j.Range
import org.eclipse.lsp4j.TextDocumentContentChangeEvent

/**
 * The text of a file in the editor. Immutable. Positions are as in the protocol: lines and UTF-16 units, counted from 0. Offsets are
 * indices into [content].
 *
 * @property uri the URI by which the editor names the file
 * @property version the editor's number for this text
 */
internal class Text(val uri: String, val version: Int, val content: String) {
    private val lines: Lines by lazy(LazyThreadSafetyMode.PUBLICATION) { Lines(content) }

    /** Returns the offset of [position]. If [position] is after the end of its line or of the text, returns the offset of this end. */
    fun offset(position: Position): Int = lines.offset(argo.check.syntax.Position(position.line + 1, position.character + 1))

    fun position(offset: Int): Position = lines.position(offset).let { Position(it.line - 1, it.column - 1) }

    fun range(span: Span): Range = Range(position(span.start), position(span.end))

    /** Returns the text after all [changes]. Each change applies to the result of the change before it. */
    fun changed(version: Int, changes: List<TextDocumentContentChangeEvent>): Text =
        changes.fold(this) { text, change -> text.changed(version, change) }

    private fun changed(version: Int, change: TextDocumentContentChangeEvent): Text {
        val range = change.range ?: return Text(uri, version, change.text)
        val begin = offset(range.start)
        val end = offset(range.end).coerceAtLeast(begin)
        return Text(uri, version, content.replaceRange(begin, end, change.text))
    }
}
