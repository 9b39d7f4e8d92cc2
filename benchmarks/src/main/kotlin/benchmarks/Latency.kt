package benchmarks

import java.util.Locale

/** A part of a course, by its exchanges at 50 a second. */
private enum class Part(val title: String, val exchanges: IntRange) {
    FIRST_SECOND("first second", 0 until 50),
    FIRST_20_SECONDS("first 20 seconds", 0 until 1000),
    AFTER_20_SECONDS("after 20 seconds", 1000 until 3000),
}

private const val ROUNDS = 3

/** The latencies in each part of a course, over all rounds. */
internal class Latencies(private val rounds: List<LongArray>) {
    val firstSecond get() = of(Part.FIRST_SECOND)
    val first20Seconds get() = of(Part.FIRST_20_SECONDS)
    val warm get() = of(Part.AFTER_20_SECONDS)

    private fun of(part: Part) = Distribution(rounds.flatMap { it.slice(part.exchanges) }.toLongArray())
}

/**
 * Measures the time from the last byte of a frame with twelve percepts, written to a pseudo-terminal, to the first byte of the command that
 * it causes. The courses take turns, so that other work of the machine affects all of them, and each starts a Java machine of its own.
 */
internal fun measureLatencies(): Map<LatencyCourse, Latencies> {
    val rounds = List(ROUNDS) { LatencyCourse.entries.associateWith(::measureApart) }
    return LatencyCourse.entries.associateWith { course -> Latencies(rounds.map { it.getValue(course) }) }
}

/** The name of the program in the Java machine of a course. */
internal const val LATENCY_COURSE = "latency-course"

private fun measureApart(course: LatencyCourse): LongArray {
    val latencies = figuresApart(LATENCY_COURSE, course.name)
    check(latencies.size > Part.entries.maxOf { it.exchanges.last }) { "${course.title} ended after ${latencies.size} exchanges" }
    return LongArray(latencies.size) { latencies[it].toLong() }
}

/** The program in the Java machine of a course: prints its latencies in ns. */
internal fun latencyCourse(name: String) {
    val exchanges = Part.entries.maxOf { it.exchanges.last } + 1
    println(LatencyCourse.valueOf(name).measure(exchanges).joinToString(" "))
}

/** Measures all courses and prints the figures, and the ratio of ARGO's latency to that of the agent on one thread. */
fun latency() {
    println("frame to command over a pseudo-terminal, 12 percepts, $ROUNDS rounds, ${machine()}:")
    val measured = measureLatencies()
    measured.forEach { (course, latencies) ->
        val parts = listOf(latencies.firstSecond, latencies.first20Seconds, latencies.warm)
        Part.entries.zip(parts).forEach { (part, it) -> println(row("${course.title}, ${part.title}", it)) }
    }
    val argo = measured.getValue(LatencyCourse.ARGO)
    val reference = measured.getValue(LatencyCourse.ONE_THREAD)
    println("ARGO in times of one thread:")
    printRatio(Part.FIRST_SECOND, argo.firstSecond, reference.firstSecond)
    printRatio(Part.FIRST_20_SECONDS, argo.first20Seconds, reference.first20Seconds)
    printRatio(Part.AFTER_20_SECONDS, argo.warm, reference.warm)
}

private fun row(what: String, latencies: Distribution) = "%-45s median %.3f ms, 99th percentile %.3f ms, longest %.3f ms".format(
    Locale.ROOT, what, latencies.ms(0.5), latencies.ms(0.99), latencies.ms(1.0),
)

private fun printRatio(part: Part, argo: Distribution, reference: Distribution) = println(
    "%-45s median %.2f, 99th percentile %.2f".format(
        Locale.ROOT, part.title, argo.ms(0.5) / reference.ms(0.5), argo.ms(0.99) / reference.ms(0.99),
    ),
)
