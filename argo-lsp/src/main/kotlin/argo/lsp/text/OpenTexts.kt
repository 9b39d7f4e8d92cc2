package argo.lsp.text

import org.eclipse.lsp4j.TextDocumentContentChangeEvent

/** The texts that the editor has open, in the order of opening. Safe for use by several threads. */
internal class OpenTexts {
    private val texts = LinkedHashMap<String, Text>()

    @Synchronized
    fun open(text: Text) {
        texts[text.uri] = text
    }

    /** Applies [changes] to the text of [uri]. Does nothing if the editor has not opened it. */
    @Synchronized
    fun change(uri: String, version: Int, changes: List<TextDocumentContentChangeEvent>) {
        texts[uri]?.let { texts[uri] = it.changed(version, changes) }
    }

    @Synchronized
    fun close(uri: String) {
        texts -= uri
    }

    @Synchronized
    operator fun get(uri: String): Text? = texts[uri]

    @Synchronized
    fun all(): List<Text> = texts.values.toList()

    /** Calls [say] if [text] is still the editor's text. Texts do not change during the call, so [say] never reports on a replaced text. */
    @Synchronized
    fun ifCurrent(text: Text, say: () -> Unit) {
        if (texts[text.uri] === text) say()
    }
}
