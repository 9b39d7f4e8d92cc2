package samples.board

import javino.LineClock
import javino.Transport
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

private const val WRITE_LIMIT_MS = 30_000

/**
 * Says [answer] as a board does that can do nothing else meanwhile: returns when its last byte has left the line.
 *
 * @param clock what bytes are timed by; the line's own
 * @return when that was, by [clock]
 * @throws javino.PortGoneException when the line is gone
 * @throws InterruptedException when this thread is interrupted
 */
internal fun Transport.say(answer: ByteArray, clock: LineClock): Long {
    write(answer, 0, answer.size, WRITE_LIMIT_MS)
    val end = clock.nanos() + answer.size * line().byteNanos()
    val lock = ReentrantLock()
    val never = lock.newCondition()
    lock.withLock { while (end - clock.nanos() > 0) clock.await(never, end - clock.nanos()) }
    return end
}
