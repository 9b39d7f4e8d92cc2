package samples.collision

import javino.LineClock
import java.util.concurrent.locks.Condition

/** A clock that only changes when it is set. No thread can wait by it. */
internal class HandClock : LineClock {
    private var nanos = 0L

    fun advance(millis: Long) {
        nanos += millis * 1_000_000
    }

    override fun nanos() = nanos

    override fun await(condition: Condition, nanos: Long) = error("this clock is set by hand, so a wait of $nanos ns would not end")
}
