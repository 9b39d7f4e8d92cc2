package samples.turtle

import java.util.concurrent.TimeUnit
import kotlin.math.cos
import kotlin.math.sin

/**
 * A turtle like those of turtlesim. The turtle drives in a square window, cannot leave it, and stops a second after its last command. Safe
 * for use by several threads.
 *
 * @param x the turtle's distance from the left edge, in m
 * @param y the turtle's distance from the lower edge, in m
 * @param heading the turtle's direction in rad. 0 is to the right, and positive angles are counter-clockwise
 * @param nanos returns the current time in ns
 */
internal class Turtle(x: Double, y: Double, heading: Double, private val nanos: () -> Long) {
    /** The turtle's position and direction, its speed in m/s and its turning speed in rad/s. */
    data class Pose(val x: Double, val y: Double, val heading: Double, val speed: Double, val turn: Double)

    private var place = Pose(x, y, heading, 0.0, 0.0)
    private var sinceNanos = nanos()
    private var commandNanos = sinceNanos

    @get:Synchronized
    val pose: Pose
        get() {
            val now = nanos()
            val isDriven = now - commandNanos < TimeUnit.SECONDS.toNanos(1)
            if (!isDriven) place = place.copy(speed = 0.0, turn = 0.0)
            place = place.after((now - sinceNanos).toDouble() / TimeUnit.SECONDS.toNanos(1))
            sinceNanos = now
            return place
        }

    /** Drives and turns at these speeds for the next second. */
    @Synchronized
    fun drive(speed: Double, turn: Double) {
        place = pose.copy(speed = speed, turn = turn)
        commandNanos = nanos()
    }

    private fun Pose.after(seconds: Double): Pose {
        val now = heading + turn * seconds
        val way = speed * seconds
        return copy(x = (x + cos(now) * way).coerceIn(0.0, WINDOW), y = (y + sin(now) * way).coerceIn(0.0, WINDOW), heading = now)
    }

    companion object {
        const val WINDOW = 11.088889
    }
}
