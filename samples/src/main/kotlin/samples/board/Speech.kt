package samples.board

import javino.LineClock
import javino.Transport

private const val WRITE_LIMIT_MS = 30_000

/**
 * Begins to send [answer].
 *
 * @param clock the clock that times bytes; the line's own
 * @return the time by [clock] at which its last byte will have left the line
 * @throws javino.PortGoneException when the line is gone
 */
internal fun Transport.beginToSay(answer: ByteArray, clock: LineClock): Long {
    write(answer, 0, answer.size, WRITE_LIMIT_MS)
    return clock.nanos() + answer.size * line().byteNanos()
}
