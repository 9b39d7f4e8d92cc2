package benchmarks

import javino.Protocol
import java.util.concurrent.atomic.AtomicLong

internal const val CROWD = "crowd"

internal const val CROWD_AGENTS = 1000

/** The heap of the Java process for the [crowd], in MB. */
internal const val CROWD_HEAP_MB = 400

/**
 * Measures a thousand agents, each with a board, in one Java process. Each agent senses twelve percepts at 10 Hz. One of them changes.
 * Returns the answers per second of all agents, and the greatest resident memory of the process in MB.
 */
internal fun crowd(): List<Double> {
    val answers = AtomicLong()
    val names = (1..CROWD_AGENTS).map { "crowd$it" }
    val board = { SensorBoard(Protocol.AUTO, ::percepts, { _, _, _ -> answers.incrementAndGet() }) }
    return withAgents(names.associateWith { board() }) { agents ->
        for (name in names) agents.start(
            name, "!start.\n+!start <- argo.port(\"sim:$name\", [baud($BAUD)]); argo.limit(100).\n+!look <- argo.percepts(open).\n",
        )
        for (name in names) agents.achieve(name, "look")
        Thread.sleep(WARM_UP_MS)
        val before = answers.get()
        val start = System.nanoTime()
        Thread.sleep(MEASURED_MS)
        listOf((answers.get() - before) * 1e9 / (System.nanoTime() - start), residentMb("VmHWM"))
    }
}

private val BESIDES = SensorBoard.robot(0).substringAfter(';')

private fun percepts(n: Int) = "dist(f,${n % 100});$BESIDES"

/** At this rate, the memory line wakes its reader once per frame, as a driver does. Lower rates wake it for each byte. */
private const val BAUD = 20_000_000
private const val WARM_UP_MS = 20_000L
private const val MEASURED_MS = 10_000L
