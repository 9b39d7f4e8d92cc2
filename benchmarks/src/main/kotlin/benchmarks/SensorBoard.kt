package benchmarks

import javino.Frame
import javino.FrameDecoder
import javino.PerceptsRequest
import javino.Protocol
import javino.Transport
import javino.sim.SimulatedBoard

/**
 * A board that answers requests at once, in the version in which it is asked, and acknowledges actions.
 *
 * @param speaks the version it reads, or both
 * @param percepts what it answers to its nth request, n counted from 1
 */
class SensorBoard(
    private val speaks: Protocol,
    private val percepts: (Int) -> String,
    private val witness: Witness = object : Witness { },
) : SimulatedBoard {
    /** Is told what happens, by the board's thread; times are of [System.nanoTime]. */
    interface Witness {
        /** The answer to request [n], whose last byte leaves the line at [endNanos]; both together are [bytes] bytes. */
        fun answered(n: Int, endNanos: Long, bytes: Int) = Unit

        /** An action came that is not the repetition of the last one. */
        fun acted(action: String) = Unit
    }

    /** Runs until [line] is gone. */
    override fun run(line: Transport) {
        val talk = Talk(line)
        val buffer = ByteArray(BUFFER)
        val decoder = FrameDecoder(FrameDecoder.interByteTimeoutNanos(line.line()), speaks, talk::handle)
        while (true) decoder.acceptAll(buffer, line.read(buffer, 0, buffer.size, READ_MS))
    }

    private fun FrameDecoder.acceptAll(buffer: ByteArray, count: Int) =
        if (count == 0) idle(System.nanoTime()) else accept(buffer, 0, count, System.nanoTime())

    private inner class Talk(private val line: Transport) {
        private var answers = 0
        private var sequence = 0
        private var last: Frame? = null

        fun handle(frame: Frame) {
            if (PerceptsRequest.isIn(frame.text())) answer(frame) else act(frame)
        }

        private fun answer(request: Frame) {
            val bytes = bytesOf(percepts(++answers), request.version())
            val start = System.nanoTime()
            line.write(bytes, 0, bytes.size, WRITE_MS)
            witness.answered(answers, start + bytes.size * line.line().byteNanos(), request.length() + bytes.size)
        }

        private fun act(action: Frame) {
            if (action.version() == 1 || action != last) witness.acted(action.text())
            last = action
            if (action.version() == 1) return
            val outcome = Frame.version2(ByteArray(0), Frame.ACK, action.sequence()).toBytes()
            line.write(outcome, 0, outcome.size, WRITE_MS)
        }

        private fun bytesOf(text: String, version: Int): ByteArray {
            if (version == 1) return Frame.of(text).toBytes()
            val parts = text.chunked(Frame.MAX_PAYLOAD)
            return parts.withIndex().fold(ByteArray(0)) { bytes, (i, part) ->
                val flags = if (i < parts.lastIndex) Frame.MORE else 0
                bytes + Frame.version2(part.toByteArray(Charsets.ISO_8859_1), flags, sequence).toBytes().also { sequence = (sequence + 1) % SEQUENCES }
            }
        }
    }

    companion object {
        private const val BUFFER = 512
        private const val READ_MS = 1000
        private const val WRITE_MS = 10_000
        private const val SEQUENCES = 16

        /** What a robot with sensors on its four sides says: twelve percepts, all of which differ from those of [n] - 1. */
        fun robot(n: Int): String {
            val sides = listOf("f", "b", "l", "r")
            val readings = sides.map { "dist($it,${n % 100 + 20})" } + sides.map { "light($it,${n % 90})" } + sides.map { "temp($it,${n % 30})" }
            return readings.joinToString(";", postfix = ";")
        }
    }
}
