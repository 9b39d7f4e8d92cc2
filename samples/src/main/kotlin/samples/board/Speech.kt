package samples.board

import javino.LineClock
import javino.Transport

private const val WRITE_LIMIT_MS = 30_000

/**
 * Begins to say [answer].
 *
 * @param clock what bytes are timed by; the line's own
 * @return when its last byte will have left the line, by [clock]
 * @throws javino.PortGoneException when the line is gone
 */
internal fun Transport.beginToSay(answer: ByteArray, clock: LineClock): Long {
    write(answer, 0, answer.size, WRITE_LIMIT_MS)
    return clock.nanos() + answer.size * line().byteNanos()
}
