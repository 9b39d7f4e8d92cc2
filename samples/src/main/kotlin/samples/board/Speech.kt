package samples.board

import javino.LineClock
import javino.Transport
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

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

/**
 * Says [answer] as a board does that can do nothing else meanwhile: returns when its last byte has left the line.
 *
 * @throws InterruptedException when this thread is interrupted
 * @see beginToSay
 */
internal fun Transport.say(answer: ByteArray, clock: LineClock) {
    val end = beginToSay(answer, clock)
    val lock = ReentrantLock()
    val never = lock.newCondition()
    lock.withLock { while (end - clock.nanos() > 0) clock.await(never, end - clock.nanos()) }
}
