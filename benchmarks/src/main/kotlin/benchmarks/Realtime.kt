package benchmarks

import javino.Protocol
import java.io.File
import java.util.Locale

/** One figure of the table. @property target its target in words; empty: there is none */
internal class Figure(val name: String, val value: Double, val unit: String, val target: String = "")

/**
 * Measures the promptness of a robot's agent: prints a table, writes it to [json], and two plots beside it as `NAME-age.svg` and
 * `NAME-line.svg`.
 */
fun realtime(json: File) = Realtime().run(json)

private class Realtime {
    private val figures = mutableListOf<Figure>()
    private val ages = mutableListOf<Ages>()
    private val lineUse = LinkedHashMap<Pair<Int, Int>, Double>()

    fun run(json: File) {
        println("real time, ${machine()}:")
        latency()
        lineUse()
        agents()
        ages()
        json.writeText(figures.joinToString(",\n", "{\"machine\": \"${machine()}\", \"figures\": [\n", "\n]}\n", transform = ::asJson))
        val stem = json.path.removeSuffix(".json")
        File("$stem-age.svg").writeText(agePlot(ages))
        File("$stem-line.svg").writeText(lineUsePlot(lineUse))
        println("all results: $json, $stem-age.svg, $stem-line.svg")
    }

    private fun show(name: String, value: Double, unit: String, target: String = "") {
        figures += Figure(name, value, unit, target)
        println("%-84s %10.3f %-4s %s".format(Locale.ROOT, name, value, unit, target).trimEnd())
    }

    private fun latency() = measureLatencies().forEach { (course, latencies) ->
        val parts = mapOf(
            "first second" to latencies.firstSecond, "first 20 seconds" to latencies.first20Seconds, "after 20 seconds" to latencies.warm,
        )
        parts.forEach { (part, distribution) ->
            show("frame to command, ${course.title}, $part, median", distribution.ms(0.5), "ms")
            show("frame to command, ${course.title}, $part, 99th percentile", distribution.ms(0.99), "ms")
        }
    }

    private fun lineUse() {
        for ((baud, target) in listOf(9600 to 95, 115_200 to 95, 1_000_000 to 80)) for (protocol in listOf(Protocol.V1, Protocol.AUTO)) {
            val version = if (protocol == Protocol.V1) 1 else 2
            val share = LineUse(baud, protocol).measure()
            lineUse[baud to version] = share
            show("line use at $baud baud, version $version, argo.limit(0)", 100 * share, "%", "at least $target")
        }
    }

    private fun agents() {
        for ((version, speaks) in listOf(1 to Protocol.V1, 2 to Protocol.V2)) {
            show("processor time of an agent, 50 Hz, pseudo-terminal, version $version", 100 * processorShare(speaks), "%", "at most 1.5")
        }
        IdleHeap().measure().forEach { (what, bytes) -> show("heap of $what that is idle", bytes / 1024, "KB", "at most 150") }
        val crowd = Crowd().measure()
        show("answers a second to ${Crowd.AGENTS} agents that sense at 10 Hz in one Java machine", crowd.rate, "1/s", "10000")
        show("memory of their process, boards included", crowd.residentMb, "MB", "less than 1024")
    }

    private fun ages() {
        for (sensors in listOf(12, 120, 1200)) for (plans in listOf(1, 10, 100)) {
            val distribution = SnapshotAge(sensors, plans).measure()
            ages += Ages(sensors, plans, distribution)
            distribution.figures().forEach { (what, ms) ->
                show("age of the snapshot acted on, $sensors sensors, $plans plans a percept, $what", ms, "ms")
            }
        }
    }

    private fun asJson(figure: Figure) = with(figure) {
        val number = if (value.isFinite()) "$value" else "null"
        "  {\"name\": \"$name\", \"value\": $number, \"unit\": \"$unit\", \"target\": \"$target\"}"
    }
}
