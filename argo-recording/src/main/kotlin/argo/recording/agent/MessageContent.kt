package argo.recording.agent

import jason.asSemantics.Agent

/** The content of a message as a text, for programs that carry messages of agents elsewhere. */
object MessageContent {
    /**
     * Returns the text of [content]: a term, or a text that Jason reads when the agent takes the message. Namespaces, annotations, strings
     * and numbers are kept.
     *
     * @throws IllegalArgumentException if it has a part that no text can hold, such as a Java object; the message names that part
     */
    fun write(content: Any?): String {
        val text = contentText(content)
        require(!TermWriter.isRefused(text)) { TermWriter.refusalOf(text) }
        return text
    }

    /**
     * Returns the content that [write] has written as [text]. No text causes a class of Java to be loaded or an object to be made.
     *
     * @param agent the agent whose functions the text may name
     * @throws IllegalArgumentException if [text] is no content, or names a function that [agent] lacks; the message says why
     */
    fun read(text: String, agent: Agent): Any = contentOf(text, agent)
}
