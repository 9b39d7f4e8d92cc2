package argo.fleet.cluster

import java.io.ByteArrayOutputStream

/** The pieces from one other computer, from their arrival until the listener has taken their messages. Callers hold a lock. */
internal class Incoming {
    private var arrived = 1L
    private var taken = 1L

    /** The number of complete messages that the listener has not yet taken. */
    private var messages = 0
    private var parts = ByteArrayOutputStream(0)

    /** The reason for each refused message, by the number of its last piece. Reasons are kept until the sender is known to have them. */
    private val refusals = sortedMapOf<Long, String>()

    /** A complete message, and the number of its last piece. */
    class Message(val number: Long, val content: ByteArray)

    /** The outcome of a piece: a complete message, an acknowledgement to send at once, or neither. */
    class Outcome(val message: Message?, val answer: Frame.Acknowledgement?)

    /** @throws IllegalArgumentException if the message is too long */
    fun take(piece: Frame.Piece): Outcome {
        refusals.headMap(piece.oldest).clear()
        if (piece.oldest > arrived) leaveOut(piece.oldest)
        if (piece.number != arrived) return Outcome(null, acknowledgement(isRepeatWanted = piece.number > arrived))
        val message = next(piece)
        return Outcome(message, if (message == null && messages == 0) acknowledgement() else null)
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
        messages++
        val content = if (parts.size() == 0) piece.content else parts.apply { writeBytes(piece.content) }.toByteArray()
        parts = ByteArrayOutputStream(0)
        return Message(piece.number, content)
    }

    /** Notes that the listener has taken the message whose last piece is [number], or has refused it for the reason [refusal]. */
    fun taken(number: Long, refusal: String?) {
        messages--
        taken = number + 1
        refusal?.let { refusals[number] = it.take(MAX_REASON) }
    }

    /** Acknowledges the pieces so far. Pieces of an unfinished message count as taken, so that the sender sends the next ones. */
    fun acknowledgement(isRepeatWanted: Boolean = false) =
        Frame.Acknowledgement(if (messages == 0) arrived else taken, arrived, isRepeatWanted, refusals.toMap())

    private companion object {
        const val MAX_REASON = 200
    }
}
