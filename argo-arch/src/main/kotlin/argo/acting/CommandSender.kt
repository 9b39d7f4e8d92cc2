package argo.acting

import argo.calls.Failure
import argo.calls.failureOf
import argo.calls.whileLost
import argo.links.BoardLink
import argo.platform.Platform
import javino.PortException
import javino.PortGoneException
import javino.SendOptions
import java.util.logging.Level
import java.util.logging.Logger

/**
 * Sends an agent's commands through the queue of one link, and reports their outcomes as failures of plans. A thread, which starts with the
 * first command, writes them until the link is closed. Safe for use by several threads.
 *
 * @param owner the agent's name, for the thread's
 * @param platform its threads
 * @param lost is called when sending finds that the port has gone; may be called again
 */
internal class CommandSender(
    private val link: BoardLink,
    private val owner: String,
    private val platform: Platform,
    private val lost: (PortException) -> Unit,
) {
    private val writer = lazy { platform.start("argo-$owner-acting-${link.port}", ::writeCommands) }

    /**
     * Queues [text], see [BoardLink.send].
     *
     * With a time limit its outcome is known when that is over: `act_timeout` if it has not begun to go out, and then it never will;
     * `act_unconfirmed` if it has, but is not known to have been carried out. One whose place a later command has taken fails with
     * `act_replaced`.
     *
     * @param left is called once, by any thread, when the command is no longer under way to the board; before [outcome]
     * @param outcome is called once, by any thread, with null when the command's last byte has left the line or, in version 2, the board
     *     has acted, else with the reason why not
     */
    fun submit(text: String, options: CommandOptions, left: () -> Unit = { }, outcome: (Failure?) -> Unit) {
        val sent = link.send(text, options.forLink())
        if (link.isOpen) writer.value
        sent.left.handle { _, _ -> left() }.thenCombine(sent.outcome.handle { _, trouble -> trouble }) { _, trouble ->
            outcome(trouble?.let(::failed))
        }.exceptionally { broken ->
            LOG.log(Level.WARNING, "what waited for the outcome of \"$text\" has failed", broken)
        }
    }

    /** Sends [text] on the caller's thread, and returns why it could not be sent; null: it was. */
    fun sendNow(text: String, options: CommandOptions): Failure? = try {
        link.sendAndAwait(text, options.forLink())
        null
    } catch (trouble: PortException) {
        failed(trouble)
    } catch (unforeseen: RuntimeException) { // whatever a transport throws
        failed(unforeseen)
    } catch (unloadable: LinkageError) { // the driver's native library
        failed(unloadable)
    }

    private fun CommandOptions.forLink() = SendOptions(urgent, timeoutMs ?: 0, latest)

    private fun failed(trouble: Throwable): Failure {
        if (trouble is PortGoneException) lost(trouble)
        return failureOf(trouble).whileLost()
    }

    private fun writeCommands() {
        try {
            link.writeCommands()
        } catch (_: PortException) {
            // the line is gone, and the commands that waited for it have failed
        }
    }

    private companion object {
        val LOG: Logger = Logger.getLogger(CommandSender::class.java.name)
    }
}
