package benchmarks.stops

import benchmarks.Distribution
import kotlin.random.Random
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.nanoseconds
import kotlin.time.Duration.Companion.seconds

/**
 * The stops of a course.
 *
 * @property responses the times from the limit to the stop in ns, in order
 * @property rests the times from the limit to the final stop, in ns. The time is longer than the response if an earlier command `front`
 * restarts the robot after a reflex
 * @property worst the timeline of the longest response, in ms after the limit
 * @property commands the number of commands that the sketch carried out
 * @property sent the number of commands sent in version 1; version 2 does not count them
 */
internal class Stops(
    val responses: List<Long>, val rests: List<Long>, val worst: String, val commands: Int, val sent: Int, val starts: Int,
) {
    val distribution = Distribution(responses.toLongArray())
}

/** The published agent stops the robot of [course] [stops] times. [seed] determines the phases between robot, line and agent. */
internal fun measureStops(course: StopCourse, stops: Int, seed: Long): Stops = CourseRun(course, publishedAgent(course)).use { run ->
    val random = Random(seed)
    run.awaitStop() // the first stop does not count, since line and agent are not yet in step
    run.rest(course.shortWay)
    val made = List(stops) { run.stop(course.shortWay, random) }
    run.agent.hears("bench", "achieve", "rest").after(QUIET)
    val worst = made.maxBy { it.response }.timeline
    Stops(made.map { it.response }, made.map { it.rest }, worst, run.robot.acted, run.uno.sent, run.robot.started)
}

private fun publishedAgent(course: StopCourse) = """
    { include("robot.asl") }
    board("uno", ${course.options}). value(${WatchedRobot.LIMIT_MM}). interval($INTERVAL_MS). view(${course.filter}).
    +!again <- .abolish(status(_)); !start.
    +!rest <- .percepts(close).
""".trimIndent()

private class Stop(val response: Long, val rest: Long, val timeline: String)

/** Puts the robot back, and makes the agent drive it to the limit again. */
private fun CourseRun.stop(way: Int, random: Random): Stop {
    val millimetres = WatchedRobot.LIMIT_MM + random.nextInt(way, 2 * way)
    val late = random.nextLong(WatchedRobot.MILLIMETRE_NANOS)
    robot.place(millimetres) { it + late }
    agent.shouldBelieve("dist(f,X) & X > ${WatchedRobot.LIMIT_MM}", within = PATIENCE)
    agent.after(timeFor(way) * random.nextDouble())
    uno.timeline.clear()
    agent.hears("bench", "achieve", "again")
    awaitStop()
    val crossedAt = checkNotNull(robot.crossedAt)
    val events = uno.timeline.since(crossedAt)
    rest(way)
    return Stop(checkNotNull(robot.stoppedAt) - crossedAt, checkNotNull(robot.restsSince) - crossedAt, events)
}

/** Waits until the agent itself has stopped the robot. A reflex may have stopped it before. */
private fun CourseRun.rest(way: Int) {
    agent.shouldBelieve("status(stopped)", within = PATIENCE)
    agent.after(timeFor(way))
}

private fun CourseRun.awaitStop() {
    val end = agent.now + PATIENCE
    do {
        check(agent.now < end) {
            "the robot has not stopped within $PATIENCE; the agent believes ${agent.beliefs} and intends ${agent.intentions}"
        }
        agent.after(LOOK)
    } while (robot.stoppedAt == null)
}

/** The shortest way of the robot to the limit, in mm. A slower line takes longer to get in step, so the way is longer. */
private val StopCourse.shortWay get() = 10 + 400_000 / baud

private fun timeFor(way: Int) = (way * WatchedRobot.MILLIMETRE_NANOS).nanoseconds

private const val INTERVAL_MS = 20
private val LOOK = 20.milliseconds
private val QUIET = 2.seconds
private val PATIENCE = 20.seconds
