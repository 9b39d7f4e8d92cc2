package argo.links

import javino.PerceptKind
import javino.PortTimeoutException
import javino.Protocol
import javino.link.BoardListener
import javino.link.Link
import javino.link.Reply
import javino.link.SendOptions
import javino.wire.BoardAction
import javino.wire.CommandItem

/** A link that carries bytes over a serial line, over a network, or to a simulated board. */
class JavinoLink(private val link: Link) : BoardLink {
    override val port: String get() = link.port()
    override val isOpen get() = link.isOpen
    override val isPaced get() = link.settings().paced()
    override val isLine get() = true
    override val canSelect get() = link.protocol() == Protocol.V2
    override val mayVanish get() = link.mayVanish()
    override val actions: List<BoardAction>? get() = link.vocabulary().orElse(null)

    override fun listen(timeoutMs: Int): BoardMessage? = try {
        link.listen(timeoutMs).toMessage()
    } catch (_: PortTimeoutException) {
        null // silence is normal: a board that sends without requests sends only news
    }

    override fun request(text: () -> String, timeoutMs: Int, intervalMs: Int): BoardMessage =
        (if (isPaced) link.request(text, timeoutMs, intervalMs) else link.request(text(), timeoutMs)).toMessage()

    override fun perceptKinds(timeoutMs: Int): List<PerceptKind> = link.perceptDescription(timeoutMs).kinds()

    override fun check() = link.check()

    override fun watch(timeoutMs: Int) = link.watch(timeoutMs)

    override fun send(text: String, options: SendOptions) = SentCommand(link.send(text, options))

    override fun sendRule(rule: CommandItem.Rule, options: SendOptions) = SentCommand(link.sendRule(rule, options))

    override fun sendAndAwait(text: String, options: SendOptions): Answer? {
        link.sendAndAwait(text, options)
        return null
    }

    override fun writeCommandsUntilClosed() = link.writeCommandsUntilClosed()

    override fun onBoardEvents(listener: BoardListener) = link.onBoardEvents(listener)

    override fun leave() = link.leave()

    override fun close() = link.close()
}

private fun Reply.toMessage() = BoardMessage(text(), receivedNanos())
