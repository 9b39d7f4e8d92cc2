package argo.fleet.cluster

import java.nio.BufferUnderflowException
import java.nio.ByteBuffer

/** The bytes that one computer sends to another in one step: a piece of a message, or an acknowledgement. Format 1. */
internal sealed interface Frame {
    fun bytes(): ByteArray

    /**
     * A message, or a part of a long one.
     *
     * @property number the piece's number in the session, across all messages
     * @property oldest the number of the oldest piece without an acknowledgement. All earlier pieces were acknowledged or reported as
     * failed
     * @property isLast true if the message ends with this piece
     */
    class Piece(val number: Long, val oldest: Long, val isLast: Boolean, val content: ByteArray) : Frame {
        override fun bytes(): ByteArray = ByteBuffer.allocate(PIECE_HEADER + content.size)
            .put(if (isLast) LAST_PIECE else PIECE).putLong(number).putLong(oldest).put(content).array()
    }

    /**
     * @property taken all pieces before this number are finished. The listener has taken them, or they have failed
     * @property arrived the number of the next awaited piece. All pieces before it have arrived
     * @property isRepeatWanted true if a later piece has arrived first. The awaited piece must then be repeated
     * @property refusals the refused messages among the finished pieces. Each key is the number of the last piece, and the value the reason
     * as [Refused.line]
     */
    class Acknowledgement(
        val taken: Long,
        val arrived: Long,
        val isRepeatWanted: Boolean,
        val refusals: Map<Long, String>,
    ) : Frame {
        override fun bytes(): ByteArray {
            val reasons = refusals.mapValues { it.value.toByteArray() }
            val size = ACKNOWLEDGEMENT_HEADER + reasons.values.sumOf { Long.SIZE_BYTES + Short.SIZE_BYTES + it.size }
            val buffer = ByteBuffer.allocate(size)
            buffer.put(if (isRepeatWanted) REPEAT else ACKNOWLEDGEMENT).putLong(taken).putLong(arrived)
            reasons.forEach { (number, reason) -> buffer.putLong(number).putShort(reason.size.toShort()).put(reason) }
            return buffer.array()
        }
    }

    companion object {
        private const val PIECE: Byte = 1
        private const val LAST_PIECE: Byte = 2
        private const val ACKNOWLEDGEMENT: Byte = 3
        private const val REPEAT: Byte = 4
        private const val ACKNOWLEDGEMENT_HEADER = 1 + 2 * Long.SIZE_BYTES

        /** The number of bytes of a piece before its content. */
        const val PIECE_HEADER = 1 + 2 * Long.SIZE_BYTES

        /** @throws IllegalArgumentException if [bytes] are no frame */
        fun of(bytes: ByteArray): Frame {
            val buffer = ByteBuffer.wrap(bytes)
            try {
                return when (val kind = buffer.get()) {
                    PIECE, LAST_PIECE -> Piece(buffer.getLong(), buffer.getLong(), kind == LAST_PIECE, buffer.rest(buffer.remaining()))
                    ACKNOWLEDGEMENT, REPEAT -> Acknowledgement(buffer.getLong(), buffer.getLong(), kind == REPEAT, refusals(buffer))
                    else -> throw IllegalArgumentException("a frame of the unknown kind $kind")
                }
            } catch (e: BufferUnderflowException) {
                throw IllegalArgumentException("a frame that ends after ${bytes.size} bytes, too early", e)
            }
        }

        private fun refusals(buffer: ByteBuffer): Map<Long, String> = buildMap {
            while (buffer.hasRemaining()) put(buffer.getLong(), String(buffer.rest(buffer.getShort().toInt() and 0xFFFF)))
        }

        private fun ByteBuffer.rest(size: Int): ByteArray {
            if (size > remaining()) throw BufferUnderflowException()
            return ByteArray(size).also(::get)
        }
    }
}
