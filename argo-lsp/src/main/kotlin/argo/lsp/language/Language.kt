package argo.lsp.language

import argo.lsp.text.Text
import org.eclipse.lsp4j.CompletionItem
import org.eclipse.lsp4j.DocumentSymbol
import org.eclipse.lsp4j.Hover
import org.eclipse.lsp4j.Location
import org.eclipse.lsp4j.Range
import org.eclipse.lsp4j.TextEdit
import org.eclipse.lsp4j.WorkspaceEdit

/** The server's help for one kind of file. Only the server's worker thread calls these functions. */
internal interface Language {
    /** Returns the words that may be inserted at [offset] of [text]. */
    fun completions(text: Text, offset: Int): List<CompletionItem> = emptyList()

    /** Returns the documentation of the word at [offset] of [text]; null if there is none. */
    fun hover(text: Text, offset: Int): Hover? = null

    /** Returns the places that define the word at [offset] of [text]. */
    fun definitions(text: Text, offset: Int): List<Location> = emptyList()

    /** Returns all places of the name at [offset] of [text]. Includes its definitions if [withDefinitions] is true. */
    fun references(text: Text, offset: Int, withDefinitions: Boolean): List<Location> = emptyList()

    /**
     * Returns the place of the name at [offset] of [text], which can be renamed; null if there is no name.
     *
     * @throws RefusedException if the name cannot be changed; its message is the reason
     */
    fun renamed(text: Text, offset: Int): Range? = null

    /**
     * Returns the changes that rename the word at [offset] of [text] to [name], with a note for the user. Returns null if the word is no
     * name.
     *
     * @throws RefusedException if the name cannot be changed; its message is the reason
     */
    fun rename(text: Text, offset: Int, name: String): Renamed? = null

    fun symbols(text: Text): List<DocumentSymbol> = emptyList()

    /** Returns the changes that give [text] its usual layout. */
    fun layout(text: Text): List<TextEdit> = emptyList()
}

/** @property note the places that the renaming does not change; null if there are none */
internal class Renamed(val edit: WorkspaceEdit, val note: String?)

/** Reports that an editor's request cannot be fulfilled. [message] tells the user the reason. */
internal class RefusedException(message: String) : Exception(message)
