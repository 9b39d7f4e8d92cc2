package argo.ros.bridge

import java.util.concurrent.CompletableFuture
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * A message for a bridge.
 *
 * @property isUrgent true if the message overtakes waiting messages that are not urgent
 * @property functor the functor of the message's command, or null if the message is no command
 * @property replaces true if the message replaces waiting messages with its [functor]
 */
internal class Outgoing(val text: String, val isUrgent: Boolean = false, val functor: String? = null, val replaces: Boolean = false) {
    /**
     * Completes when the operating system has taken the message. Completes exceptionally if the message is never sent. Any thread may
     * complete it.
     */
    val left = CompletableFuture<Unit>()

    @Volatile
    var hasBegun = false
        private set

    private var isWithdrawn = false // guarded by this object, like hasBegun

    /** Marks the message as being sent. Returns false if it was withdrawn. */
    fun begin(): Boolean = synchronized(this) { (!isWithdrawn).also { hasBegun = it } }

    /** Withdraws the message. Returns false if sending has begun. */
    fun withdraw(): Boolean = synchronized(this) { (!hasBegun).also { isWithdrawn = it } }
}

/** A newer command has replaced this waiting command. */
internal class Replaced : Exception()

/** The connection was closed before the message went out. */
internal class NeverSent : Exception()

/** The messages that wait for a connection. The connection takes one message at a time. Safe for use by several threads. */
internal class Outbox(private val write: (String) -> CompletableFuture<*>) : AutoCloseable {
    private val lock = ReentrantLock()
    private val waiting = ArrayDeque<Outgoing>()
    private var isBusy = false
    private var isClosed = false

    fun add(message: Outgoing) {
        val replaced = lock.withLock {
            if (isClosed) null
            else waiting.filter { message.replaces && it.functor == message.functor && it.withdraw() }.also { put(message, it) }
        }
        if (replaced == null) message.left.completeExceptionally(NeverSent())
        replaced?.forEach { it.left.completeExceptionally(Replaced()) }
    }

    private fun put(message: Outgoing, replaced: List<Outgoing>) {
        val place = replaced.firstOrNull { it.isUrgent == message.isUrgent }?.let(waiting::indexOf)
            ?: if (message.isUrgent) waiting.indexOfFirst { !it.isUrgent }.takeIf { it >= 0 } ?: waiting.size else waiting.size
        waiting.add(place, message)
        waiting.removeAll(replaced.toSet())
    }

    /** Starts to send the next message if the connection is free. */
    fun flush() {
        val message = lock.withLock {
            if (isBusy || isClosed) return
            var first: Outgoing?
            do first = waiting.removeFirstOrNull() while (first != null && !first.begin())
            isBusy = first != null
            first
        } ?: return
        val sent = try {
            write(message.text)
        } catch (broken: RuntimeException) {
            CompletableFuture.failedFuture<Unit>(broken)
        }
        sent.whenComplete { _, trouble ->
            lock.withLock { isBusy = false }
            if (trouble == null) message.left.complete(Unit) else message.left.completeExceptionally(trouble)
            flush()
        }
    }

    /** Fails all waiting messages. No message is sent after this call. */
    override fun close() {
        val left = lock.withLock {
            isClosed = true
            waiting.toList().also { waiting.clear() }
        }
        left.forEach { if (it.withdraw()) it.left.completeExceptionally(NeverSent()) }
    }
}
