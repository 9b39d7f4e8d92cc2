package argo.acting

import argo.acting.Command.State
import argo.calls.Failure
import argo.calls.failureOf
import argo.platform.Platform
import javino.Link
import javino.PortException
import javino.PortGoneException
import kotlin.concurrent.withLock

/**
 * The commands that wait for one port. One thread writes them, urgent ones first and else in their order, at the pace of the line; it
 * starts with the first command and ends with [close]. Safe for use by several threads.
 *
 * @param owner the agent's name, for the thread's
 * @param platform its time and threads
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
    private val urgent = ArrayDeque<Command>()
    private val ordinary = ArrayDeque<Command>()
    private var writing: Command? = null
    private var submitted = 0L
    private var finished = 0L
    private var nextCheckNanos: Long? = null
    private var closed = false
    private val writer = lazy { platform.start("argo-$owner-acting-${link.port()}", ::writeAll) }

    /**
     * Queues [text].
     *
     * With a time limit its outcome is known when that is over: `act_timeout` if it has not begun to go out, and then it never will;
     * `act_unconfirmed` if it has, but is not known to have been carried out.
     *
     * @param outcome is called once by another thread, with null when the command's last byte has left the line or, in version 2,
     * the board has acted, else with the reason why it has not
     */
    fun submit(text: String, options: CommandOptions = CommandOptions(), outcome: (Failure?) -> Unit) {
        val command = command(text, options, outcome)
        lock.withLock {
            submitted++
            (if (command.urgent) urgent else ordinary).addLast(command)
            moved.signalAll()
            checkBy(command)
        }
        if (lock.withLock { closed }) failWaiting() else writer.value
    }

    /** Writes [text] on the caller's thread, without waiting for a turn among the commands, and says why if it could not. */
    fun write(text: String, options: CommandOptions = CommandOptions()): Failure? {
        var result: Failure? = null
        val command = command(text, options) { result = it }
        val failure = transmit(command) { lock.withLock { begin(command) } }
        if (command.state == State.WAITING && command.isLate(platform.clock.nanos())) finish(command, tooLate(command)) else finish(command, failure)
        return result
    }

    private fun command(text: String, options: CommandOptions, outcome: (Failure?) -> Unit) =
        Command(text, options.urgent, options.timeoutMs?.let { platform.clock.nanos() + it * NANOS_PER_MS }, outcome)

    /** Waits, at most [limitNanos] ns, until as many commands are out or have failed as were submitted before this call. */
    fun awaitEarlier(limitNanos: Long) = lock.withLock {
        val earlier = submitted
        var left = limitNanos
        while (finished < earlier && left > 0) left = moved.awaitNanos(left)
    }

    /** Fails the commands that wait and ends the thread. The link must be closed as well. May be called twice. */
    fun close() {
        lock.withLock {
            closed = true
            moved.signalAll()
            if (writer.isInitialized()) writer.value.interrupt()
        }
        failWaiting()
    }

    private fun writeAll() {
        try {
            while (true) send(next() ?: break)
        } catch (_: InterruptedException) {
            // close() ends this thread
        }
        failWaiting()
    }

    /** The command whose turn it is now; null: there will be none. */
    private fun next(): Command? = lock.withLock {
        while (!closed && urgent.isEmpty() && ordinary.isEmpty()) moved.await()
        if (closed) null else (urgent.removeFirstOrNull() ?: ordinary.removeFirst()).also { writing = it }
    }

    private fun send(command: Command) {
        val failure = transmit(command) { lock.withLock { !isOvertaken(command) && begin(command) } }
        val isOvertaken = lock.withLock {
            writing = null
            if (!closed) Thread.interrupted() // expire() may have ended the waiting for an outcome that does not matter any more
            (command.state == State.WAITING && failure == null && !command.isLate(platform.clock.nanos())).also { if (it) ordinary.addFirst(command) }
        }
        if (isOvertaken) return
        finish(command, if (lock.withLock { command.state == State.WAITING } && command.isLate(platform.clock.nanos())) tooLate(command) else failure)
    }

    /** Whether an urgent command has come while [command] waited for its turn on the line. */
    private fun isOvertaken(command: Command) = !command.urgent && urgent.isNotEmpty()

    /** Whether [command] is still wanted now that its turn on the line has come; then it goes out. */
    private fun begin(command: Command): Boolean {
        if (command.state != State.WAITING || command.isLate(platform.clock.nanos())) return false
        command.state = State.SENDING
        return true
    }

    /** Writes [command] if it still [goes] when its turn on the line has come, and says why if it could not. */
    private fun transmit(command: Command, goes: () -> Boolean): Failure? = try {
        link.send(command.text, WRITE_LIMIT_MS, goes)
        null
    } catch (gone: PortGoneException) {
        if (!lock.withLock { closed }) lost(gone)
        failureOf(gone)
    } catch (trouble: PortException) {
        if (lock.withLock { closed }) wasClosed() else failureOf(trouble) // close() interrupts what the link has not ended yet
    } catch (unforeseen: RuntimeException) { // the commands behind it must go on, whatever a transport throws
        failureOf(unforeseen)
    } catch (unloadable: LinkageError) { // the driver's native library
        failureOf(unloadable)
    }

    /** Sees to it that commands are looked through when the time of [command] is over. */
    private fun checkBy(command: Command) {
        val deadline = command.deadlineNanos ?: return
        if (nextCheckNanos?.let { it - deadline <= 0 } == true) return
        nextCheckNanos = deadline
        platform.later(maxOf(0, deadline - platform.clock.nanos()) / NANOS_PER_MS + 1, ::expire)
    }

    /** Ends the commands whose time is over. */
    private fun expire() {
        val late = lock.withLock {
            val now = platform.clock.nanos()
            val late = live().filter { it.isLate(now) }
            if (nextCheckNanos?.let { it - now <= 0 } == true) nextCheckNanos = null
            live().filter { !it.isLate(now) && it.deadlineNanos != null }.minByOrNull { it.leftNanos(now)!! }?.let(::checkBy)
            urgent.removeAll(late)
            ordinary.removeAll(late)
            if (late.any { it === writing && it.state == State.SENDING } && writer.isInitialized()) writer.value.interrupt()
            late.map { command -> command to (if (command.state == State.SENDING) unconfirmed(command) else tooLate(command)).also { end(command) } }
        }
        late.forEach { (command, failure) -> tell(command, failure) }
    }

    private fun live() = (listOfNotNull(writing) + urgent + ordinary).filter { it.state != State.OVER }

    private fun tooLate(command: Command) = Failure(
        "act_timeout",
        "\"${command.text}\" had not begun to go out through port ${link.port()} when its time was over, so it was not sent; other commands, or the board, take the line's time",
    )

    private fun unconfirmed(command: Command) = Failure(
        "act_unconfirmed",
        "\"${command.text}\" was on its way through port ${link.port()} when its time was over, and is not known to have arrived; it may have been carried out",
    )

    private fun failWaiting() {
        val failed = lock.withLock { (urgent + ordinary).also { urgent.clear(); ordinary.clear() } }
        failed.forEach { finish(it, wasClosed()) }
    }

    private fun wasClosed() = Failure("port_gone", "the port ${link.port()} was closed, or its device went, before it was sent")

    private fun finish(command: Command, failure: Failure?) {
        if (lock.withLock { end(command) }) tell(command, failure)
    }

    /** Says that the outcome of [command] is known; false if it had been already. */
    private fun end(command: Command): Boolean = (command.state != State.OVER).also { command.state = State.OVER }

    private fun tell(command: Command, failure: Failure?) {
        command.outcome(failure)
        lock.withLock {
            finished++
            moved.signalAll()
        }
    }

    companion object {
        /** How long a line may refuse to take one command, in ms. */
        const val WRITE_LIMIT_MS = 5000
        private const val NANOS_PER_MS = 1_000_000L
    }
}
