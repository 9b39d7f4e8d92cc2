package argo.testkit

import argo.links.Answer
import argo.links.BoardLink
import argo.links.SentCommand
import javino.link.SendOptions

internal class NotedLink(private val link: BoardLink, private val note: (String) -> Unit) : BoardLink by link {
    override fun send(text: String, options: SendOptions): SentCommand {
        note(text)
        return link.send(text, options)
    }

    override fun sendAndAwait(text: String, options: SendOptions): Answer? {
        note(text)
        return link.sendAndAwait(text, options)
    }
}
