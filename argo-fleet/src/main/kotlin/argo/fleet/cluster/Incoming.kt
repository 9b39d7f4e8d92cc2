package argo.fleet.cluster

import java.io.ByteArrayOutputStream

/**
 * The pieces from one other computer, from their arrival until the listener has taken their messages. Callers hold a lock. A sender that
 * ignores the window of [Outgoing], or never learns which of its messages were refused, costs no more memory than any other.
 */
internal class Incoming {
    private var arrived = 1L
    private var taken = 1L

    /** The sizes in bytes of the complete messages that the listener has not yet taken, the oldest first. */
    private val untaken = ArrayDeque<Int>()
    private var bytesUntaken = 0L
    private var parts = ByteArrayOutputStream(0)

    /** The reason for each refused message, by the number of its last piece. Reasons are kept until the sender is known to have them. */
    private val refusals = sortedMapOf<Long, String>()

    /** A complete message, and the number of its last piece. */
    class Message(val number: Long, val content: ByteArray)

    /** The outcome of a piece: a complete message, an acknowledgement to send at once, or neither. */
    class Outcome(val message: Message?, val answer: Frame.Acknowledgement?)

    /** @throws IllegalArgumentException if the message is too long */
    fun take(piece: Frame.Piece): Outcome {
        refusals.headMap(maxOf(piece.oldest, piece.number - Outgoing.WINDOW_PIECES)).clear()
        if (piece.oldest > arrived) leaveOut(piece.oldest)
        if (piece.number != arrived) return Outcome(null, acknowledgement(isRepeatWanted = piece.number > arrived))
        if (untaken.size >= MOST_UNTAKEN || bytesUntaken > MOST_BYTES_UNTAKEN) return Outcome(null, null) // the sender will repeat it
        val message = next(piece)
        return Outcome(message, if (message == null && untaken.isEmpty()) acknowledgement() else null)
    }

    /** Leaves out the pieces before [number], which the sender has given up. */
    private fun leaveOut(number: Long) {
        arrived = number
        parts = ByteArrayOutputStream(0)
    }

    private fun next(piece: Frame.Piece): Message? {
        require(parts.size() + piece.content.size <= Outgoing.MAX_MESSAGE) { "a message of more than ${Outgoing.MAX_MESSAGE} bytes" }
        arrived++
        if (!piece.isLast) {
            parts.writeBytes(piece.content)
            return null
        }
        val content = if (parts.size() == 0) piece.content else parts.apply { writeBytes(piece.content) }.toByteArray()
        parts = ByteArrayOutputStream(0)
        untaken += content.size
        bytesUntaken += content.size
        return Message(piece.number, content)
    }

    /** Notes that the listener has taken the message whose last piece is [number], or has refused it for the reason [refusal]. */
    fun taken(number: Long, refusal: String?) {
        bytesUntaken -= untaken.removeFirst()
        taken = number + 1
        refusal?.let { refusals[number] = it.take(MAX_REASON) }
    }

    /** Acknowledges the pieces so far. Pieces of an unfinished message count as taken, so that the sender sends the next ones. */
    fun acknowledgement(isRepeatWanted: Boolean = false) =
        Frame.Acknowledgement(if (untaken.isEmpty()) arrived else taken, arrived, isRepeatWanted, refusals.toMap())

    private companion object {
        const val MAX_REASON = 200

        /** Twice what waits of one session, since the sender may have given up the messages before, which still wait here. */
        const val MOST_UNTAKEN = 2 * Outgoing.WINDOW_PIECES
        const val MOST_BYTES_UNTAKEN = 2L * Outgoing.MAX_MESSAGE
    }
}
