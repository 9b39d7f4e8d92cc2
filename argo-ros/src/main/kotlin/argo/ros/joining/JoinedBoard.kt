package argo.ros.joining

import argo.links.BoardLink
import argo.links.Wish
import argo.links.errorOf
import javino.PerceptsRequest
import javino.PortException
import javino.PortInterruptedException
import javino.PortTimeoutException
import javino.link.SendOptions
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonPrimitive
import java.util.concurrent.CompletionException
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/**
 * A board in a ROS graph, without an agent. The program requests percepts at an interval, and reopens the board after a loss. Each command
 * is sent once at most.
 *
 * @param intervalMs the time between two requests, in ms
 * @param timeoutMs the longest wait for an answer, in ms
 * @param listens true if the board sends percepts without requests
 * @param warn takes reports of unpublished percepts, each text once
 */
internal class JoinedBoard(
    override val name: String,
    private val port: String,
    private val topics: Topics,
    private val intervalMs: Int,
    private val timeoutMs: Int,
    private val listens: Boolean,
    private val open: () -> BoardLink,
    private val tell: (String) -> Unit,
    warn: (String) -> Unit,
) : Participant, AutoCloseable {
    private val closed = CountDownLatch(1)
    private val publisher = PerceptPublisher("/$name", topics, warn)
    private val thread = Thread(::run, "argo-ros-$name").apply { isDaemon = true }
    private var status = ""

    @Volatile
    private var link: BoardLink? = null

    @Volatile
    private var known: List<BoardAction>? = null

    override val actions: List<BoardAction>?
        get() = (link?.actions ?: known)?.takeIf { it.isNotEmpty() }?.also { known = it }

    fun start() = thread.start()

    private val isClosed get() = closed.count == 0L

    private fun run() {
        while (!isClosed) {
            try {
                open().use(::ask)
            } catch (_: PortInterruptedException) {
                return
            } catch (gone: PortException) {
                off("${gone.message}")
            } catch (unforeseen: Throwable) { // an unexpected error must not end this thread
                off("it failed: $unforeseen")
            }
            try {
                closed.await(RETRY_MS, TimeUnit.MILLISECONDS)
            } catch (_: InterruptedException) {
                return
            }
        }
    }

    private fun off(why: String) {
        link = null
        report("off", "/$name: $why; it is opened again as soon as it is there")
    }

    private fun ask(opened: BoardLink) {
        opened.wants(Wish(true, intervalMs, null))
        link = opened
        Thread({ writeCommands(opened) }, "argo-ros-$name-acting").apply { isDaemon = true }.start()
        var due = System.nanoTime()
        while (!isClosed) {
            try {
                val message = if (listens || opened.speaksUnasked) opened.listen(timeoutMs)
                else opened.request({ PerceptsRequest.ALL }, timeoutMs, intervalMs)
                report("on", "/$name: the board at port $port is there")
                if (message != null) publisher.publish(message.text)
            } catch (late: PortTimeoutException) {
                report("timeout", "/$name: ${late.message}")
            }
            due = maxOf(due + TimeUnit.MILLISECONDS.toNanos(intervalMs.toLong()), System.nanoTime()) // skips missed requests
            if (!listens && !opened.speaksUnasked) waitUntil(due)
        }
    }

    private fun waitUntil(nanos: Long) {
        try {
            closed.await(nanos - System.nanoTime(), TimeUnit.NANOSECONDS)
        } catch (_: InterruptedException) {
            throw PortInterruptedException(port)
        }
    }

    private fun writeCommands(opened: BoardLink) {
        try {
            opened.writeCommandsUntilClosed()
        } catch (_: PortException) {
            // the sensing thread detects the lost board
        } catch (unforeseen: Throwable) { // closing the link makes the sensing thread reopen it
            tell("/$name: the thread that sends commands has ended, so the board is opened anew: $unforeseen")
            opened.close()
        }
    }

    private fun report(word: String, message: String) {
        if (word == status) return
        status = word
        topics.publish("/$name/port", STRING, listOf(data(JsonPrimitive(word))))
        tell(message)
    }

    override fun act(command: String, options: SendOptions, done: (Outcome) -> Unit) {
        val opened = link ?: return done(Outcome("no_port", "the board at port $port is not there now"))
        try {
            opened.send(command, options).outcome.whenComplete { _, trouble -> done(outcomeOf(trouble)) }
        } catch (unsendable: IllegalArgumentException) { // the text does not fit into a frame
            done(Outcome("wrong_arguments", unsendable.message.orEmpty()))
        }
    }

    override fun close() {
        closed.countDown()
        thread.interrupt()
        link?.close()
    }

    private companion object {
        const val RETRY_MS = 500L
    }
}

/**
 * Returns the outcome of a command that failed with [trouble], with the error name that agents use. If [trouble] is null, the command was
 * carried out.
 */
internal fun outcomeOf(trouble: Throwable?): Outcome {
    val cause = if (trouble is CompletionException) trouble.cause else trouble
    return if (cause == null) Outcome.DONE else Outcome(errorOf(cause), cause.message ?: "$cause")
}
