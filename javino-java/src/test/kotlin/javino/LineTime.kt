package javino

import java.util.concurrent.locks.Condition

/** A clock that only its line moves: a thread that waits for a signal which does not come waits for ever. */
internal class LineTime : LineClock {
    @Volatile
    var now = 0L

    override fun nanos() = now

    override fun await(condition: Condition, nanos: Long) = condition.await()
}
