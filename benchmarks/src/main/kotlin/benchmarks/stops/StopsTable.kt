package benchmarks.stops

import benchmarks.Distribution
import benchmarks.figures
import java.io.File
import kotlin.time.Duration.Companion.microseconds

private const val STOPS = 40
private const val SEED = 1L

private val HEAD = figures(
    "%-62s %8s %8s %8s %8s   %-14s %9s %5s %7s", "", "median", "99 %", "worst", "for good", "the line alone", "commands", "lost", "starts",
)

private val COURSES = buildList {
    for (baud in listOf(9_600, 115_200)) for (version in listOf(2, 1)) add(StopCourse(baud, version))
    for (baud in listOf(9_600, 115_200)) for (loopMs in listOf(5, 20)) add(StopCourse(baud, loopMs = loopMs))
    add(StopCourse(9_600, cycleTime = 900.microseconds))
    for (filter in listOf("critical", "criticalReflex")) for (baud in listOf(9_600, 115_200)) add(StopCourse(baud, filter = filter))
    for (loopMs in listOf(0, 2, 5, 10)) add(StopCourse(9_600, 1, Firmware.FIELD, loopMs))
}

/**
 * The published agent stops a simulated robot in front of a wall, on each course. Prints the time from the limit to the stop. Writes the
 * timeline of each course's worst stop to [timelines]. Virtual time makes the figures independent of the machine. Returns false if the
 * firmware has not been built.
 */
fun stops(timelines: File): Boolean {
    if (!Bench.isBuilt(COURSES)) {
        System.err.println("there is no simulator, or not all robots: make -C javino-arduino bench; ./argo firmware installs what it needs")
        return false
    }
    timelines.writeText("")
    println("from the limit to the stop, twelve sensors that all change, published agent, $STOPS stops each, virtual time; ms")
    println(HEAD)
    val lines = LinkedHashMap<StopCourse, LineFigures>()
    for (course in COURSES) {
        val plain = StopCourse(course.baud, course.version, course.firmware, course.loopMs)
        val stops = measureStops(course, STOPS, SEED)
        println(row(course, stops, lines.getOrPut(plain) { measureLine(plain) }))
        timelines.appendText("$course, the worst stop, ms from the limit on\n${stops.worst}\n")
    }
    println("snapshots a second, no commands, argo.limit(0)")
    lines.forEach { (course, line) -> println(row(course, line)) }
    println("the worst stop of each: $timelines")
    return true
}

private fun row(course: StopCourse, stops: Stops, line: LineFigures) = with(stops.distribution) {
    figures(
        "%-62s %8.1f %8.1f %8.1f %8.1f   %5.0f to %4.0f  %9d %5s %7d", course, ms(0.5), ms(0.99), ms(1.0),
        Distribution(stops.rests.toLongArray()).ms(1.0), line.shortestMs, line.longestMs, stops.commands,
        if (course.version == 1) "${stops.sent - stops.commands}" else "", stops.starts,
    )
}

private fun row(course: StopCourse, line: LineFigures) = figures(
    "%-62s %8.1f   %d and %d bytes a snapshot, %d and %d a command", course, line.snapshotsPerSecond, line.snapshot.toBoard,
    line.snapshot.toComputer, line.command.toBoard, line.command.toComputer,
)
