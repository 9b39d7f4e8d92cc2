package argo.acting

import argo.calls.Failure
import argo.calls.NO_ANSWER
import argo.calls.failureOf
import argo.calls.whileLost
import argo.links.Answer
import argo.links.BoardLink
import argo.links.SentCommand
import argo.platform.Platform
import javino.PortException
import javino.PortFaultException
import javino.PortGoneException
import javino.PortInterruptedException
import javino.link.SendOptions
import javino.wire.CommandItem
import java.util.logging.Level
import java.util.logging.Logger

/**
 * Sends an agent's commands through the queue of one link, and reports their outcomes as failures of plans. The first command starts a
 * thread, which writes commands until the link is closed. If the thread ends for another reason, the port counts as lost. Safe for use by
 * several threads.
 *
 * @param lost called if the port is found to be gone, perhaps repeatedly, by any thread; must not wait
 */
internal class CommandSender(
    private val link: BoardLink,
    private val owner: String,
    private val platform: Platform,
    private val lost: (PortException) -> Unit,
) {
    private val writer = lazy { platform.start("argo-$owner-acting-${link.port}", ::writeCommands) }

    /** Queues [text], see [BoardLink.send]. If the line is free, writes it at once. */
    fun send(text: String, options: CommandOptions): Transmission =
        transmission("\"$text\"", link.send(text, options.forLink()), options.answer != null)

    /** Sends [change], a change of the board's rules, ahead of waiting commands. */
    fun send(change: CommandItem.Rule): Transmission =
        transmission("a rule", link.sendRule(change, CommandOptions(urgent = true).forLink()), isAnswered = false)

    private fun transmission(what: String, sent: SentCommand, isAnswered: Boolean): Transmission {
        if (link.isOpen) writer.value
        return Transmission(sent.giveUp) { left, outcome ->
            follow(what, sent, left) { value, trouble ->
                val answer = (value as? Answer)?.takeIf { isAnswered }
                outcome(trouble?.let(::failed) ?: missing(what, answer), answer?.text)
            }
        }
    }

    private fun missing(what: String, answer: Answer?) = answer?.why?.let { Failure(NO_ANSWER, "$what was carried out, but $it") }

    private fun follow(what: String, sent: SentCommand, left: () -> Unit, outcome: (value: Any?, trouble: Throwable?) -> Unit) {
        val end = sent.outcome.handle { value: Any?, trouble: Throwable? -> value to trouble }
        val ended =
            if (sent.left === sent.outcome) end.thenApply { it.also { left() } }
            else sent.left.handle { _, _ -> left() }.thenCombine(end) { _, both -> both }
        ended.thenAccept { (value, trouble) -> outcome(value, trouble) }.exceptionally { broken ->
            null.also { LOG.log(Level.WARNING, "the receiver of the outcome of $what has failed", broken) }
        }
    }

    /** Sends [text] on the caller's thread, and waits for the outcome. */
    fun sendNow(text: String, options: CommandOptions): Transmission = try {
        val answer = link.sendAndAwait(text, options.forLink())?.takeIf { options.answer != null }
        ended(missing("\"$text\"", answer), answer?.text)
    } catch (trouble: PortException) {
        ended(failed(trouble))
    } catch (unforeseen: Throwable) { // a transport may throw anything
        ended(failed(unforeseen))
    }

    private fun CommandOptions.forLink() = SendOptions(urgent, timeoutMs ?: 0, latest)

    private fun failed(trouble: Throwable): Failure {
        if (trouble is PortGoneException) lost(trouble)
        return failureOf(trouble).whileLost()
    }

    private fun writeCommands() {
        try {
            link.writeCommandsUntilClosed()
        } catch (_: PortGoneException) {
            // the waiting commands have failed already
        } catch (_: PortInterruptedException) {
            // the port is closed
        } catch (unforeseen: Throwable) { // a new opening of the port starts a new thread
            lost(PortFaultException(link.port, "the thread that sends commands ended: $unforeseen", unforeseen))
        }
    }

    private companion object {
        val LOG: Logger = Logger.getLogger(CommandSender::class.java.name)
    }
}
