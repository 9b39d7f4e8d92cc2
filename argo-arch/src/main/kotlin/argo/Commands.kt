package argo

import javino.Link
import javino.PortException
import javino.PortGoneException
import kotlin.concurrent.withLock

/**
 * The commands that wait for one port. One thread writes them in their order, at the pace of the line; it starts with the
 * first command and ends with [close].
 *
 * @param owner the agent's name, for the thread's
 * @param lost is called when writing finds that the port has gone
 */
internal class Commands(
    private val link: Link,
    private val owner: String,
    private val platform: Platform,
    private val lost: (PortException) -> Unit,
) {
    private val lock = platform.clock.newLock(false)
    private val moved = lock.newCondition()
    private val queue = ArrayDeque<Command>()
    private var submitted = 0L
    private var finished = 0L

    @Volatile
    private var closed = false
    private val writer = lazy { platform.start("argo-$owner-acting-${link.port()}", ::writeAll) }

    /**
     * Queues [text].
     *
     * @param outcome is called once by another thread, with null when the command's last byte has left the line or, in version 2,
     * the board has acted, else with the reason why it has not
     */
    fun submit(text: String, outcome: (Failure?) -> Unit) {
        lock.withLock {
            submitted++
            queue.addLast(Command(text, outcome))
            moved.signalAll()
        }
        if (closed) failWaiting() else writer.value
    }

    /** Waits, at most [limitNanos] ns, until the commands submitted before this call are out or have failed. */
    fun awaitEarlier(limitNanos: Long) = lock.withLock {
        val earlier = submitted
        var left = limitNanos
        while (finished < earlier && left > 0) left = moved.awaitNanos(left)
    }

    /** Fails the commands that wait and ends the thread. The link must be closed as well. May be called twice. */
    fun close() {
        closed = true
        failWaiting()
        if (writer.isInitialized()) writer.value.interrupt()
    }

    private fun writeAll() {
        try {
            while (!closed) next().let { finish(it, write(it.text)) }
        } catch (_: InterruptedException) {
            // close() ends this thread
        }
        failWaiting()
    }

    private fun next(): Command = lock.withLock {
        while (queue.isEmpty()) moved.await()
        queue.removeFirst()
    }

    /** Writes [text] on the caller's thread, without waiting for a turn, and says why if it could not. */
    fun write(text: String): Failure? = try {
        link.send(text, WRITE_LIMIT_MS)
        null
    } catch (gone: PortGoneException) {
        if (!closed) lost(gone)
        failureOf(gone)
    } catch (trouble: PortException) {
        if (closed) wasClosed() else failureOf(trouble) // close() interrupts what the link has not ended yet
    } catch (unforeseen: RuntimeException) { // the commands behind it must go on, whatever a transport throws
        failureOf(unforeseen)
    } catch (unloadable: LinkageError) { // the driver's native library
        failureOf(unloadable)
    }

    private fun failWaiting() {
        while (true) finish(lock.withLock { queue.removeFirstOrNull() } ?: return, wasClosed())
    }

    private fun wasClosed() = Failure("port_gone", "the port ${link.port()} was closed, or its device went, before it was sent")

    private fun finish(command: Command, failure: Failure?) {
        command.outcome(failure)
        lock.withLock {
            finished++
            moved.signalAll()
        }
    }

    private class Command(val text: String, val outcome: (Failure?) -> Unit)

    companion object {
        /** How long a line may refuse to take one command, in ms. */
        const val WRITE_LIMIT_MS = 5000
    }
}
