package experiment

import javino.LineClock
import samples.collision.Witness

/**
 * Detects when an agent perceives that its robot is at most [limit] cm from the wall. Only the agent's thread may call [see]. Any thread
 * may read. Times are ns of one steady clock.
 */
internal class Sighting(private val limit: Int) {
    private var above: Pair<Double, Long>? = null

    /**
     * The time at which the believed readings crossed the limit, or null before that. The time is interpolated with constant speed, between
     * the last reading above the limit and the first one at or below it. The delay from the sensor to the agent is ignored.
     */
    @Volatile
    var crossed: Long? = null
        private set

    /** The time at which the agent first believed a front distance at or below the limit, or null before that. */
    @Volatile
    var perceived: Long? = null
        private set

    /** Takes the front distance [front] that the agent believes from [now] on, or null for none. */
    fun see(front: Double?, now: Long) {
        if (front == null || perceived != null) return
        if (front > limit) {
            above = front to now
            return
        }
        crossed = above?.let { (cm, at) -> at + ((now - at) * (cm - limit) / (cm - front)).toLong() } ?: now
        perceived = now
    }

    fun witness(record: RecordWriter, begin: Long, clock: LineClock) = Witness { front, events, intentions ->
        val now = clock.nanos()
        see(front, now)
        record.write(Entry.Belief(now - begin, front, events, intentions))
    }
}
