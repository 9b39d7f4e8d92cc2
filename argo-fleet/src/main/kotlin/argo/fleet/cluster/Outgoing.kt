package argo.fleet.cluster

import java.util.concurrent.CompletableFuture

/**
 * The messages to one other computer, from [Cluster.send] until their outcome is known. Pieces go out in order, and at most [WINDOW_BYTES]
 * and [WINDOW_PIECES] are under way. Lost pieces are sent again. Callers hold a lock, and pass the time in nanoseconds.
 *
 * @param first the number of the first piece
 */
internal class Outgoing(private val to: String, first: Long) {
    private class Waiting(val frame: (oldest: Long) -> Frame.Piece, val size: Int, val number: Long, val done: CompletableFuture<Void>?) {
        var sentAt = 0L
    }

    /** The piece that was last sent again to learn which pieces the receiver lacks. */
    private class Asked(val number: Long, val at: Long)

    /** The outcome of a [Cluster.send]: [done] completes with [failure]; null: it succeeds. */
    class End(val done: CompletableFuture<Void>, val failure: Exception?)

    /** The pieces without an acknowledgement, the oldest first. The first [sent] of them are under way. */
    private val waiting = ArrayDeque<Waiting>()
    private var sent = 0
    private var bytesSent = 0
    private var bytesWaiting = 0L
    private var patience = FIRST_PATIENCE_NANOS
    private var asked: Asked? = null
    private var repeatedFrom = 0L
    private var repeatedAt = 0L

    /** The number of the next piece. */
    var next = first
        private set

    /** Whether the outcome of all messages is known. */
    val isEmpty: Boolean get() = waiting.isEmpty()

    private val oldest get() = waiting.firstOrNull()?.number ?: next

    /** @throws Overloaded if [message] is too long, or too much waits */
    fun add(message: ByteArray, done: CompletableFuture<Void>) {
        if (message.size > MAX_MESSAGE) {
            throw Overloaded("a message of ${message.size} bytes to $to is too long; the longest has $MAX_MESSAGE")
        }
        if (bytesWaiting + message.size > MAX_BYTES_WAITING || waiting.size >= MAX_PIECES_WAITING) {
            throw Overloaded("${waiting.size} pieces of messages, $bytesWaiting bytes, wait for $to, which takes them too slowly")
        }
        for (from in 0..(message.size - 1).coerceAtLeast(0) step PIECE) {
            val end = minOf(from + PIECE, message.size)
            val number = next++
            val isLast = end == message.size
            val content = if (from == 0 && isLast) message else message.copyOfRange(from, end)
            waiting += Waiting({ Frame.Piece(number, it, isLast, content) }, content.size + OVERHEAD, number, done.takeIf { isLast })
        }
        bytesWaiting += message.size
    }

    /** Returns the pieces that must go out now. */
    fun due(now: Long): List<Frame.Piece> = buildList {
        while (sent < waiting.size && (sent == 0 || bytesSent + waiting[sent].size <= WINDOW_BYTES && sent < WINDOW_PIECES)) {
            val piece = waiting[sent++]
            piece.sentAt = now
            bytesSent += piece.size
            add(piece.frame(oldest))
        }
    }

    /** Returns the oldest piece, to be sent again, if it has been under way for long. The receiver's answer shows which pieces it lacks. */
    fun overdue(now: Long): Frame.Piece? {
        val first = waiting.firstOrNull()?.takeIf { sent > 0 && now - it.sentAt >= patience } ?: return null
        asked = Asked(first.number, now)
        first.sentAt = now
        patience = minOf(2 * patience, MAX_PATIENCE_NANOS)
        return first.frame(oldest)
    }

    /** Takes an acknowledgement, and returns the outcomes that are known by it. After that, [due] may return further pieces. */
    fun acknowledged(news: Frame.Acknowledgement, now: Long): List<End> {
        val ends = mutableListOf<End>()
        while (sent > 0 && waiting.first().number < news.taken) {
            val piece = waiting.removeFirst()
            forget(piece)
            patience = FIRST_PATIENCE_NANOS
            piece.done?.let { ends += End(it, news.refusals[piece.number]?.let(Refused::of)) }
        }
        if (isLost(news, now)) goBack(news.arrived, now)
        return ends
    }

    /** Whether the awaited piece was lost: the receiver has got a later piece, or an older piece that was sent again afterwards. */
    private fun isLost(news: Frame.Acknowledgement, now: Long): Boolean {
        val place = news.arrived - oldest
        val awaited = if (place in 0..<sent) waiting[place.toInt()] else return false
        val isOvertaken = news.isRepeatWanted && (news.arrived != repeatedFrom || now - repeatedAt >= REPEAT_NANOS)
        val isAnswered = asked?.let { news.arrived > it.number && awaited.sentAt < it.at } ?: false
        if (isAnswered) asked = null
        return isOvertaken || isAnswered
    }

    private fun goBack(number: Long, now: Long) {
        repeatedFrom = number
        repeatedAt = now
        while (sent > 0 && waiting[sent - 1].number >= number) bytesSent -= waiting[--sent].size
    }

    private fun forget(piece: Waiting) {
        sent--
        bytesSent -= piece.size
        bytesWaiting -= piece.size - OVERHEAD
    }

    /** Gives up all messages, so that none is sent again. */
    fun giveUp(reason: String): List<End> {
        val ends = waiting.mapNotNull { it.done }.map { End(it, Unreachable(reason)) }
        waiting.clear()
        sent = 0
        bytesSent = 0
        bytesWaiting = 0
        patience = FIRST_PATIENCE_NANOS
        asked = null
        return ends
    }

    companion object {
        /** The longest message, in bytes. */
        const val MAX_MESSAGE = 8 shl 20

        /** The most bytes that may wait for one computer. */
        private const val MAX_BYTES_WAITING = 16L shl 20
        private const val MAX_PIECES_WAITING = 100_000

        /** The size of a long message's pieces, in bytes. On a slow line, signs of life go out between two pieces. */
        private const val PIECE = 16 shl 10

        /** The bytes of the headers that this format, JGroups and TCP add to each piece. */
        private const val OVERHEAD = 120

        /**
         * The most bytes under way. They fit into the system's buffers for a connection, which hold at least twice 100 KB. So a write never
         * waits for a computer that does not read, which would delay signs of life to other computers.
         */
        private const val WINDOW_BYTES = 64 shl 10
        const val WINDOW_PIECES = 512

        /** The first time after which a piece is sent again. TCP loses pieces only when a connection ends, which is noticed earlier. */
        private const val FIRST_PATIENCE_NANOS = 200_000_000L
        private const val MAX_PATIENCE_NANOS = 1_000_000_000L

        /** Each piece that arrives after a lost one causes a request for a repeat. Within this time, only the first one counts. */
        private const val REPEAT_NANOS = 100_000_000L
    }
}
