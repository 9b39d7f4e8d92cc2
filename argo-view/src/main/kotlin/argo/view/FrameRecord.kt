package argo.view

import argo.observing.PerceivedMessage
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** The newest messages that a view has not looked at yet. Safe for use by several threads; nothing takes longer than a note. */
internal class FrameRecord {
    private val lock = ReentrantLock()
    private val unseen = ArrayDeque<PerceivedMessage>()
    private var lastReceived: Long? = null
    private var messages = 0L

    /** How many messages there were; a second look at the same one does not count. */
    val count: Long get() = lock.withLock { messages }

    /** Notes [message]. */
    fun add(message: PerceivedMessage) = lock.withLock {
        if (message.receivedNanos != lastReceived) messages++
        lastReceived = message.receivedNanos
        if (unseen.size == MOST_UNSEEN) unseen.removeFirst()
        unseen += message
    }

    /** What has been noted since the last call, the newest last. */
    fun take(): List<PerceivedMessage> = lock.withLock { unseen.toList().also { unseen.clear() } }

    private companion object {
        /** As many as a board that sends its percepts one by one says in a tenth of a second at 115200 baud. */
        const val MOST_UNSEEN = 64
    }
}
