package argo.recording.agent

import jason.asSemantics.Agent

/** Writes the content of a message as a text and reads it back. Programs that send agents' messages over other channels use it. */
object MessageContent {
    /**
     * Returns the text of [content]: a term, or a text that Jason reads when the agent takes the message. The text keeps namespaces,
     * annotations, strings and numbers.
     *
     * @throws IllegalArgumentException if no text can contain a part of [content], such as a Java object; the message names this part
     */
    fun write(content: Any?): String {
        val text = contentText(content)
        require(!TermWriter.isRefused(text)) { TermWriter.refusalOf(text) }
        return text
    }

    /**
     * Returns the content that [write] has written as [text]. A class that [text] names is never loaded or instantiated.
     *
     * @param agent the text may name functions of this agent
     * @throws IllegalArgumentException if [text] is no content, or names a function that [agent] lacks; the message says why
     */
    fun read(text: String, agent: Agent): Any = contentOf(text, agent)
}
