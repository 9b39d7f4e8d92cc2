package javino

import java.util.concurrent.locks.Condition

/** A clock that only its line moves. A thread waits for ever if its signal does not come. */
internal class LineTime : LineClock {
    @Volatile
    var now = 0L

    override fun nanos() = now

    override fun await(condition: Condition, nanos: Long) = condition.await()
}
