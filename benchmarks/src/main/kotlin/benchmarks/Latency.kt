package benchmarks

/** A part of a course, given by the numbers of its [exchanges]. There are 50 exchanges per second. */
internal enum class Part(val title: String, val exchanges: IntRange) {
    FIRST_SECOND("first second", 0 until 50),
    FIRST_20_SECONDS("first 20 seconds", 0 until 1000),
    AFTER_20_SECONDS("after 20 seconds", 1000 until 3000),
}

private const val ROUNDS = 3
private val EXCHANGES = Part.entries.maxOf { it.exchanges.last } + 1

/**
 * Measures the latency of commands over a pseudo-terminal in several rounds. The latency is the time from the last byte of a frame with
 * twelve percepts to the first byte of its command. The courses alternate, so that other load on the machine affects all of them. Each
 * course runs in a new Java process.
 */
internal fun measureLatencies(): Map<LatencyCourse, Map<Part, Distribution>> {
    val rounds = List(ROUNDS) { LatencyCourse.entries.associateWith(::measureApart) }
    return LatencyCourse.entries.associateWith { course ->
        Part.entries.associateWith { part -> Distribution(rounds.flatMap { it.getValue(course).slice(part.exchanges) }.toLongArray()) }
    }
}

internal const val LATENCY_COURSE = "latency-course"

private fun measureApart(course: LatencyCourse): List<Long> {
    val latencies = figuresApart(LATENCY_COURSE, course.name)
    check(latencies.size >= EXCHANGES) { "${course.title} ended after ${latencies.size} exchanges" }
    return latencies.map(Double::toLong)
}

internal fun latencyCourse(name: String): List<Long> = LatencyCourse.valueOf(name).measure(EXCHANGES).asList()

/** Measures all courses. Prints the figures, and the ratio of ARGO's latency to that of the single-threaded agent. */
internal fun latency() {
    println("frame to command over a pseudo-terminal, 12 percepts, $ROUNDS rounds, ${machine()}:")
    val measured = measureLatencies()
    measured.forEach { (course, latencies) ->
        latencies.forEach { (part, it) ->
            val title = "${course.title}, ${part.title}"
            println(
                figures("%-45s median %.3f ms, 99th percentile %.3f ms, longest %.3f ms", title, it.ms(0.5), it.ms(0.99), it.ms(1.0)),
            )
        }
    }
    println("ARGO in times of one thread:")
    for (part in Part.entries) {
        val argo = measured.getValue(LatencyCourse.ARGO).getValue(part)
        val reference = measured.getValue(LatencyCourse.ONE_THREAD).getValue(part)
        val ratios = listOf(0.5, 0.99).map { argo.ms(it) / reference.ms(it) }
        println(figures("%-45s median %.2f, 99th percentile %.2f", part.title, *ratios.toTypedArray()))
    }
}
