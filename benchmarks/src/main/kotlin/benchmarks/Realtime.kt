package benchmarks

import javino.Protocol
import java.io.File

/** One figure of the table. @property target what it should not exceed or fall below, in words; empty: nothing */
internal class Figure(val name: String, val value: Double, val unit: String, val target: String = "")

/** Measures what makes a robot's agent prompt, prints a table and writes it to [json]. */
fun realtime(json: File) {
    val figures = mutableListOf<Figure>()
    fun show(vararg more: Figure) = more.forEach {
        figures += it
        println("%-70s %10.3f %-6s %s".format(it.name, it.value, it.unit, it.target))
    }
    println("real time, ${machine()}:")
    measureLatency().let {
        show(
            Figure("frame to command over a pseudo-terminal, median", it.ms(0.5), "ms", "at most 0.5"),
            Figure("frame to command over a pseudo-terminal, 99th percentile", it.ms(0.99), "ms", "at most 3"),
        )
    }
    for ((baud, target) in listOf(9600 to 95, 115_200 to 95, 1_000_000 to 80)) for (protocol in listOf(Protocol.V1, Protocol.AUTO)) {
        val version = if (protocol == Protocol.V1) 1 else 2
        show(Figure("line use at $baud baud, version $version, argo.limit(0)", 100 * LineUse(baud, protocol).measure(), "%", "at least $target"))
    }
    show(Figure("processor time of an agent that senses at 50 Hz", 100 * processorShare(), "%", "at most 2"))
    IdleHeap().measure().forEach { (what, bytes) -> show(Figure("heap of $what that is idle", bytes / 1024, "KB", "at most 150")) }
    Crowd().measure().let {
        show(
            Figure("answers a second, 1000 agents at 10 Hz", it.rate, "1/s", "10000"),
            Figure("memory of their process", it.residentMb, "MB", "less than 1024"),
        )
    }
    for (sensors in listOf(12, 120, 1200)) for (plans in listOf(1, 10, 100)) {
        SnapshotAge(sensors, plans).measure().figures().forEach { (what, ms) ->
            show(Figure("age of a snapshot when acted on, $sensors sensors, $plans plans a percept, $what", ms, "ms"))
        }
    }
    json.writeText(figures.joinToString(",\n", "{\"machine\": \"${machine()}\", \"figures\": [\n", "\n]}\n", transform = ::asJson))
    println("all results: $json")
}

private fun asJson(figure: Figure) = with(figure) {
    val number = if (value.isFinite()) "$value" else "null"
    "  {\"name\": \"$name\", \"value\": $number, \"unit\": \"$unit\", \"target\": \"$target\"}"
}
