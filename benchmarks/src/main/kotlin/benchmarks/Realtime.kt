package benchmarks

import javino.Protocol
import java.io.File

internal fun realtime(json: File) {
    println("real time, ${machine()}:")
    val table = Table()
    showLatencies(table)
    showLineUse(table)
    showAgents(table)
    showAges(table)
    table.writeTo(json)
    println("all results: $json")
}

private class Table {
    private val rows = mutableListOf<String>()

    /** @param target the target in words, or an empty text without one */
    fun show(name: String, value: Double, unit: String, target: String = "") {
        val number = if (value.isFinite()) "$value" else "null"
        rows += "  {\"name\": \"$name\", \"value\": $number, \"unit\": \"$unit\", \"target\": \"$target\"}"
        println(figures("%-84s %10.3f %-4s %s", name, value, unit, target).trimEnd())
    }

    fun writeTo(json: File) = json.writeText(rows.joinToString(",\n", "{\"machine\": \"${machine()}\", \"figures\": [\n", "\n]}\n"))
}

private fun showLatencies(table: Table) = measureLatencies().forEach { (course, latencies) ->
    latencies.forEach { (part, distribution) ->
        table.show("frame to command, ${course.title}, ${part.title}, median", distribution.ms(0.5), "ms")
        table.show("frame to command, ${course.title}, ${part.title}, 99th percentile", distribution.ms(0.99), "ms")
    }
}

private fun showLineUse(table: Table) {
    for ((baud, target) in listOf(9600 to 95, 115_200 to 95, 1_000_000 to 80)) {
        fun show(what: String, share: Double) =
            table.show("line use at $baud baud, $what, argo.limit(0)", 100 * share, "%", "at least $target")
        show("version 1", lineUse(baud, Protocol.V1))
        show("version 1, spacing(0)", lineUse(baud, Protocol.V1, ", spacing(0)"))
        show("version 2", lineUse(baud, Protocol.AUTO))
    }
}

private fun showAgents(table: Table) {
    for ((version, speaks) in listOf(1 to Protocol.V1, 2 to Protocol.V2)) {
        table.show("processor time of an agent, 50 Hz, pseudo-terminal, version $version", 100 * processorShare(speaks), "%", "at most 1.5")
    }
    idleHeap().forEach { (what, bytes) -> table.show("heap of $what that is idle", bytes / 1024, "KB", "at most 150") }
    val (rate, residentMb) = figuresApart(CROWD, options = listOf("-Xmx${CROWD_HEAP_MB}m"))
    table.show("answers a second to $CROWD_AGENTS agents that sense at 10 Hz in one Java machine", rate, "1/s", "10000")
    table.show("memory of their process, boards included", residentMb, "MB", "less than 1024")
}

private fun showAges(table: Table) {
    for (sensors in listOf(12, 120, 1200)) for (plans in listOf(1, 10, 100)) {
        val ages = snapshotAge(sensors, plans)
        for ((what, share) in listOf("median" to 0.5, "p90" to 0.9, "p99" to 0.99, "longest" to 1.0)) {
            table.show("age of the snapshot acted on, $sensors sensors, $plans plans a percept, $what", ages.ms(share), "ms")
        }
    }
}
