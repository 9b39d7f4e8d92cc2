package samples.collision

import java.util.Locale

/** The result of a run of the collision experiment. [exitStatus] is the program's exit status: 0 if the robot was stopped. */
internal sealed class Verdict(val sentence: String, val exitStatus: Int) {
    /**
     * The robot was stopped [distance] cm from the wall. The stop came [nanosAfter] ns after the limit, or before the limit if [nanosAfter]
     * is null.
     */
    class Stopped(distance: Double, limit: Int, nanosAfter: Long?) : Verdict(
        "stopped ${cm(distance)} cm from the wall, " +
            if (nanosAfter == null) "before the $limit cm limit" else "${nanosAfter / 1_000_000} ms after the $limit cm limit",
        0,
    )

    /** The robot ran into the wall [nanosAfter] ns after the limit. */
    class Collided(limit: Int, nanosAfter: Long) :
        Verdict("ran into the wall: the agent had not stopped the robot ${seconds(nanosAfter)} s after the $limit cm limit", 1)

    /** The agent has sent `stop` to a real robot. The robot's front sensor showed [distance] cm. */
    class Sent(distance: Double?, limit: Int) : Verdict(
        "stopped: " + (distance?.let { "the front sensor says ${cm(it)} cm" } ?: "the front sensor says nothing") +
            ", the limit is $limit cm",
        0,
    )

    class Failed(why: String) : Verdict(why, 1)
}

internal fun cm(distance: Double): String = String.format(Locale.ROOT, "%.1f", distance)

internal fun seconds(nanos: Long): String = String.format(Locale.ROOT, "%.1f", nanos / 1e9)
