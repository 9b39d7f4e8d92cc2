package argo.lsp.language

import argo.lsp.text.Text
import org.eclipse.lsp4j.CompletionItem
import org.eclipse.lsp4j.Diagnostic
import org.eclipse.lsp4j.DocumentSymbol
import org.eclipse.lsp4j.Hover
import org.eclipse.lsp4j.Location
import org.eclipse.lsp4j.Range
import org.eclipse.lsp4j.TextEdit
import org.eclipse.lsp4j.WorkspaceEdit

/** What the server can tell of one kind of file. Only the server's worker thread calls it. */
internal interface Language {
    /** Returns what is wrong with [text]. */
    fun diagnostics(text: Text): List<Diagnostic>

    /** Returns what may be written at [offset] of [text]. */
    fun completions(text: Text, offset: Int): List<CompletionItem> = emptyList()

    /** Returns the documentation of what stands at [offset] of [text]; null: there is none. */
    fun hover(text: Text, offset: Int): Hover? = null

    /** Returns the places that give a meaning to what stands at [offset] of [text]. */
    fun definitions(text: Text, offset: Int): List<Location> = emptyList()

    /** Returns all places of what stands at [offset] of [text], with its definitions if [withDefinitions]. */
    fun references(text: Text, offset: Int, withDefinitions: Boolean): List<Location> = emptyList()

    /**
     * Returns the name at [offset] of [text] that can be changed; null: there is none.
     *
     * @throws RefusedException with the reason, if there is a name that cannot
     */
    fun renamed(text: Text, offset: Int): Range? = null

    /**
     * Returns the changes that give [name] to what stands at [offset] of [text], and a note to the person; null: it has no name.
     *
     * @throws RefusedException with the reason, if that cannot be
     */
    fun rename(text: Text, offset: Int, name: String): Renamed? = null

    /** Returns the parts of [text]. */
    fun symbols(text: Text): List<DocumentSymbol> = emptyList()

    /** Returns the blanks of [text] that its layout changes. */
    fun layout(text: Text): List<TextEdit> = emptyList()
}

/** @property note what the renaming leaves as it is; null: nothing */
internal class Renamed(val edit: WorkspaceEdit, val note: String?)

/** The editor asks for something that cannot be; [message] gives a person the reason. */
internal class RefusedException(message: String) : Exception(message)
