package benchmarks.stops

import javino.LineSettings
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/**
 * The traffic on a course's line.
 *
 * @property snapshotsPerSecond the snapshots per second of an agent that senses without an interval and does not act
 * @property snapshot the bytes of a request and its answer
 */
internal class LineFigures(val snapshotsPerSecond: Double, val snapshot: Traffic, val command: Traffic, private val byteNanos: Long) {
    /** The time in ms from the limit to the stop if only the line takes time. The sensors are read exactly at the limit. */
    val shortestMs: Double get() = (snapshot.toBoard + snapshot.toComputer + command.toBoard) * byteNanos / NANOS_PER_MS

    /** The time of [shortestMs] if the sensors are read just before the limit, and again in the next snapshot. */
    val longestMs: Double get() = shortestMs + (snapshot.toBoard + snapshot.toComputer) * byteNanos / NANOS_PER_MS
}

internal fun measureLine(course: StopCourse): LineFigures {
    val (snapshots, sensed) = CourseRun(course, senses(course)).use { run ->
        run.agent.after(SETTLED)
        val before = run.robot.looked to run.uno.traffic
        run.agent.after(WINDOW)
        run.robot.looked - before.first to run.uno.traffic - before.second
    }
    val acted = CourseRun(course, acts(course)).use { run ->
        run.agent.after(SETTLED)
        val idle = run.trafficOf { } // the link also sends frames of its own
        run.trafficOf { run.agent.hears("bench", "achieve", "stop") } - idle
    }
    return LineFigures(
        snapshots / WINDOW.inWholeSeconds.toDouble(), sensed / snapshots, acted / COMMANDS, LineSettings(course.baud).byteNanos(),
    )
}

private fun CourseRun.trafficOf(command: () -> Unit): Traffic {
    val before = uno.traffic
    repeat(COMMANDS) {
        command()
        agent.after(BETWEEN)
    }
    return uno.traffic - before
}

private operator fun Traffic.div(times: Int) = Traffic((toBoard + times / 2) / times, (toComputer + times / 2) / times)

private fun senses(course: StopCourse) =
    "!start.\n+!start <- argo.port(\"uno\", ${course.options}); argo.limit(0); argo.percepts(open)."

private fun acts(course: StopCourse) = "!start.\n+!start <- argo.port(\"uno\", ${course.options}).\n+!stop <- argo.act(stop)."

private const val NANOS_PER_MS = 1e6
private const val COMMANDS = 10
private val SETTLED = 2.seconds
private val WINDOW = 5.seconds
private val BETWEEN = 200.milliseconds
