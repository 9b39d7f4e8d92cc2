package samples.collision

import javino.LineClock

/** A running experiment for spectators. */
internal interface Scene {
    /** Returns facts about the run, such as `distance 87.3 cm`, `driving` and `4.2 s`. */
    fun look(): List<String>

    /** Returns a picture of the run. Safe for use by several threads. */
    fun picture(): TrackPicture

    /** Returns the result, or null during the run. */
    fun verdict(): Verdict?

    /** Returns the verdict on a run that was ended after [seconds] s because it took too long. */
    fun overdue(seconds: Long): Verdict
}

/**
 * The scene of the simulated [robot], whose true position is known. A run ends only when the agent believes that it has stopped the robot.
 * An agent that still waits for an answer would continue to drive.
 */
internal class SimulatedScene(
    private val robot: Robot, private val beliefs: () -> Witness.Beliefs, private val limit: Int, private val clock: LineClock,
) : Scene {
    override fun look(): List<String> {
        val now = clock.nanos()
        val course = robot.course
        return listOf(
            "distance ${cm(course.distanceAt(now))} cm", words(course.stateAt(now)), "${seconds(now - (course.departure ?: now))} s",
        )
    }

    override fun picture(): TrackPicture {
        val now = clock.nanos()
        val course = robot.course
        return TrackPicture(course.distanceAt(now), limit, Course.START_CM, words(course.stateAt(now)))
    }

    override fun verdict(): Verdict? {
        val now = clock.nanos()
        val course = robot.course
        val state = course.stateAt(now)
        val believed = beliefs()
        return when {
            state == Course.State.COLLIDED ->
                Verdict.Collided(limit, between(course.reached(limit.toDouble(), now), course.reached(0.0, now)) ?: 0)
            state == Course.State.STOPPED && believed.isStopped ->
                Verdict.Stopped(course.distanceAt(now), limit, between(course.reached(limit.toDouble(), now), course.halt))
            else -> believed.trouble?.let { Verdict.Failed(it) }
        }
    }

    override fun overdue(seconds: Long) =
        Verdict.Failed("the robot has neither stopped nor reached the wall within $seconds s; last seen: ${look().joinToString()}")

    private fun between(earlier: Long?, later: Long?): Long? = if (earlier == null || later == null) null else later - earlier

    private fun words(state: Course.State) = state.name.lowercase()
}

/** The scene of a real robot on [port]. Only the agent's beliefs tell its position. */
internal class BoardScene(
    private val witness: Witness, private val port: String, private val limit: Int, private val clock: LineClock,
) : Scene {
    private val begin = clock.nanos()

    override fun look(): List<String> {
        val beliefs = witness.beliefs
        val distance = beliefs.distance?.let { "distance ${cm(it)} cm" } ?: "no distance yet"
        return listOf(distance, doing(beliefs), "${seconds(clock.nanos() - begin)} s")
    }

    override fun picture(): TrackPicture {
        val beliefs = witness.beliefs
        return TrackPicture(beliefs.distance, limit, maxOf(Course.START_CM, limit.toDouble()), doing(beliefs))
    }

    private fun doing(beliefs: Witness.Beliefs): String = when {
        beliefs.port == null -> "opening the port"
        beliefs.port != "on" -> "the board does not answer"
        beliefs.status == "front" -> "driving"
        else -> beliefs.status ?: "waiting for the board"
    }

    override fun verdict(): Verdict? = with(witness.beliefs) {
        when {
            trouble != null -> Verdict.Failed(trouble)
            isStopped -> Verdict.Sent(distance, limit)
            else -> null
        }
    }

    override fun overdue(seconds: Long): Verdict {
        val cause = when {
            witness.beliefs.port == "timeout" -> "the board on $port does not answer"
            witness.beliefs.distance == null -> "the board on $port has sent no dist(f,Cm)"
            else -> "the robot on $port has not come within $limit cm of the wall"
        }
        return Verdict.Failed("$cause in $seconds s; last seen: ${look().joinToString()}")
    }
}
