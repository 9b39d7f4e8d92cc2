package samples.turtle

import java.util.concurrent.TimeUnit

/** A robot that drives straight at a wall, by the time of [nanos]. Safe for use by several threads. */
internal class Turtle(private val nanos: () -> Long) {
    private var metres = 0.0
    private var metresPerSecond = 0.0
    private var sinceNanos = nanos()

    /** The turtle's distance from its dock, in m. The turtle stays at the wall. */
    @get:Synchronized
    val position: Double
        get() = (metres + metresPerSecond * (nanos() - sinceNanos) / TimeUnit.SECONDS.toNanos(1)).coerceIn(0.0, WALL)

    val range: Double get() = WALL - position

    @get:Synchronized
    val isDriving: Boolean get() = metresPerSecond != 0.0

    /** Drives at this speed from now on; backwards if it is negative. */
    @Synchronized
    fun drive(metresPerSecond: Double) {
        metres = position
        sinceNanos = nanos()
        this.metresPerSecond = metresPerSecond
    }

    companion object {
        /** The place of the wall, in m from the dock. */
        const val WALL = 1.5
    }
}
