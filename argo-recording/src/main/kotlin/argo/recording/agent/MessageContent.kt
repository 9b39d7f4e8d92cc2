package argo.recording.agent

import jason.asSemantics.Agent

/** Writes the content of a message as a text and reads it back, for programs that send agents' messages elsewhere. */
object MessageContent {
    /**
     * Returns the text of [content]: a term, or a text that Jason reads when the agent takes the message. Namespaces, annotations, strings
     * and numbers are kept.
     *
     * @throws IllegalArgumentException if [content] has a part that no text can hold, such as a Java object; the message names that part
     */
    fun write(content: Any?): String {
        val text = contentText(content)
        require(!TermWriter.isRefused(text)) { TermWriter.refusalOf(text) }
        return text
    }

    /**
     * Returns the content that [write] has written as [text]. No text can make Java load or instantiate a class that the text names.
     *
     * @param agent the agent whose functions the text may name
     * @throws IllegalArgumentException if [text] is no content, or names a function that [agent] lacks; the message says why
     */
    fun read(text: String, agent: Agent): Any = contentOf(text, agent)
}
