package experiment

import javino.LineClock
import samples.collision.Witness

/**
 * Notes when an agent perceives that its robot is at most [limit] cm from the wall. Only the agent's thread may call [see]; any thread may
 * read. Instants are ns of one steady clock.
 */
internal class Sighting(private val limit: Int) {
    private var above: Pair<Double, Long>? = null

    /**
     * The instant at which the believed readings crossed the limit; null until then. The instant is interpolated, for a constant speed,
     * between the last reading above the limit and the first one at or below it. It ignores the time from a sensor to the agent.
     */
    @Volatile
    var crossed: Long? = null
        private set

    /** The instant at which the agent first believed a front distance at or below the limit; null until then. */
    @Volatile
    var perceived: Long? = null
        private set

    /** Notes that the agent believes the front distance [front] since [now]; null: it believes none. */
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
