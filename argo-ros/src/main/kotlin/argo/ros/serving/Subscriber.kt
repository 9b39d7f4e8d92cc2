package argo.ros.serving

import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** The way to a client. No function waits; all may be called by any thread. */
internal interface ClientSocket {
    /** Sends [text]. */
    fun send(text: String)

    /** Sends a ping that holds [number], which the client sends back when it has read all earlier messages. */
    fun ping(number: Long)

    /** Ends the connection for [reason]. */
    fun end(reason: String)
}

/**
 * Sends to one client. Topics are sent in rounds: each has the newest messages of the due topics, and the next waits until the client has
 * read the one before. So a slow client reads messages no older than one round takes, and none pile up, neither here nor on the network.
 * Safe for use by several threads.
 *
 * @param nanos the time
 * @param random a number that a client cannot know before it has read it
 * @param later does something after this many ns
 */
internal class Subscriber(
    private val socket: ClientSocket,
    private val nanos: () -> Long,
    private val random: () -> Long,
    private val later: (delayNanos: Long, action: () -> Unit) -> Unit,
) : TopicReader {
    private class Wish(val throttleNanos: Long, val kept: Int)

    private class Topic {
        val wishes = HashMap<String, Wish>() // by the ids of the subscriptions
        val waiting = ArrayDeque<String>()
        var name = "" to "" // and the client's name for the topic
        var throttleNanos = 0L
        var kept = 1
        var sentNanos: Long? = null

        fun renamed(operation: String): String {
            val (name, asked) = name
            return if (name == asked) operation else operation.replaceFirst("\"$name\"", "\"$asked\"")
        }
    }

    private val lock = ReentrantLock()
    private val topics = LinkedHashMap<String, Topic>() // guarded by lock, as all below
    private var subscriptions = 0
    private var ping: Long? = null // the ping that is not answered
    private var pingedNanos = 0L
    private var heardNanos = nanos()
    private var wakeNanos: Long? = null
    private var sentChars = 0L // since the last answered ping
    private var pingedChars = 0L // of these, before the ping
    private var isEnded = false

    /**
     * Subscribes to [topic], or changes the subscription [id]. Of several ids, the shortest interval and the longest queue count.
     *
     * @param newest the message that is sent at once
     * @param asked the client's name for the topic, by which it finds it
     * @return false: there are too many subscriptions
     */
    fun subscribe(topic: String, id: String, throttleMs: Long, queueLength: Int, newest: String?, asked: String = topic): Boolean {
        lock.withLock {
            if (topics[topic]?.wishes?.contains(id) != true && ++subscriptions > MAX_SUBSCRIPTIONS) {
                subscriptions--
                return false
            }
            val its = topics.getOrPut(topic, ::Topic)
            val isNew = its.wishes.isEmpty()
            val throttleNanos = TimeUnit.MILLISECONDS.toNanos(throttleMs.coerceIn(0, MAX_THROTTLE_MS))
            its.wishes[id] = Wish(throttleNanos, queueLength.coerceIn(1, MAX_QUEUE))
            its.renew()
            its.name = topic to asked
            if (isNew && newest != null && its.waiting.isEmpty()) its.waiting.addLast(its.renamed(newest))
        }
        sendDue()
        return true
    }

    /** Ends the subscription [id] of [topic], or all of them if it is null. */
    fun unsubscribe(topic: String, id: String?): Unit = lock.withLock {
        val its = topics[topic] ?: return
        val ended = if (id == null) its.wishes.size else if (id in its.wishes) 1 else 0
        subscriptions -= ended
        if (id == null) its.wishes.clear() else its.wishes -= id
        if (its.wishes.isEmpty()) topics -= topic else its.renew()
    }

    private fun Topic.renew() {
        throttleNanos = wishes.values.minOf { it.throttleNanos }
        kept = wishes.values.maxOf { it.kept }
    }

    override fun published(topic: String, operation: String, isEvent: Boolean) {
        lock.withLock {
            val its = topics[topic] ?: return
            its.waiting.addLast(its.renamed(operation))
            while (its.waiting.size > if (isEvent) MAX_QUEUE else its.kept) its.waiting.removeFirst()
        }
        sendDue()
    }

    /** Sends [text], an answer, at once. Disconnects a client that does not read its answers. */
    fun send(text: String): Unit = lock.withLock {
        if (isEnded) return
        socket.send(text)
        sentChars += text.length
        if (ping == null) sendPing()
        if (sentChars > MAX_UNREAD) end("it does not read what it is sent")
    }

    /** Counts [chars] that the socket has sent by itself. */
    fun sent(chars: Int) = lock.withLock {
        sentChars += chars
        if (ping == null && !isEnded) sendPing()
        if (sentChars > MAX_UNREAD) end("it does not read what it is sent")
    }

    private fun sendPing() {
        val number = random()
        ping = number
        pingedNanos = nanos()
        pingedChars = sentChars
        socket.ping(number)
    }

    /** Notes that the client has answered the ping [number]. */
    fun answered(number: Long) {
        lock.withLock {
            heardNanos = nanos()
            if (number != ping) return
            ping = null
            sentChars -= pingedChars
        }
        sendDue()
    }

    /** Notes that a message of the client has come. */
    fun isAlive() = lock.withLock { heardNanos = nanos() }

    /** Disconnects a client that has gone without closing the connection. Call it about once a second. */
    fun check(): Unit = lock.withLock {
        if (isEnded) return
        val now = nanos()
        if (ping != null && now - pingedNanos > LOST_NANOS) end("it does not answer a ping")
        if (ping == null && now - heardNanos > IDLE_NANOS) sendPing()
    }

    /** Stops sending. */
    fun stop() = lock.withLock {
        isEnded = true
        topics.clear()
    }

    private fun end(reason: String) {
        if (isEnded) return
        isEnded = true
        topics.clear()
        socket.end(reason)
    }

    private fun sendDue(): Unit = lock.withLock {
        if (isEnded || ping != null) return
        val now = nanos()
        val waiting = topics.values.filter { it.waiting.isNotEmpty() }
        val (due, early) = waiting.partition { it.remainingNanos(now) <= 0 }
        due.forEach { it.sendDue(now) }
        if (due.isNotEmpty()) return sendPing()
        val next = early.minOfOrNull { it.remainingNanos(now) } ?: return
        wakeIn(next, now)
    }

    private fun Topic.remainingNanos(now: Long) = sentNanos?.let { it + throttleNanos - now } ?: 0

    /** Sends the due messages of the topic: with an interval, one in each. */
    private fun Topic.sendDue(now: Long) {
        sentNanos = now
        do {
            val text = waiting.removeFirst()
            socket.send(text)
            sentChars += text.length
        } while (throttleNanos == 0L && waiting.isNotEmpty())
    }

    private fun wakeIn(delay: Long, now: Long) {
        val due = now + delay
        if (wakeNanos?.let { it - now > 0 && it - due <= 0 } == true) return
        wakeNanos = due
        later(delay) { sendDue() }
    }

    companion object {
        /** The largest number of a client's subscriptions. */
        const val MAX_SUBSCRIPTIONS = 1_000

        /** The longest queue of a subscription, and of results. */
        const val MAX_QUEUE = 100
        private const val MAX_THROTTLE_MS = 86_400_000L

        /** The most characters on their way to a client that does not show that it reads them. */
        const val MAX_UNREAD = 4L * 1024 * 1024
        private val LOST_NANOS = TimeUnit.SECONDS.toNanos(20)
        private val IDLE_NANOS = TimeUnit.SECONDS.toNanos(20)
    }
}
