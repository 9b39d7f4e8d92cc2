package benchmarks.ros

import benchmarks.Agents
import benchmarks.Distribution
import benchmarks.figures
import benchmarks.programApart
import java.nio.file.Files
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ConcurrentLinkedQueue

internal const val REACTING_AGENT = "reacting-agent"

private const val HZ = 50
private const val ROUNDS = 12
private const val UNCOUNTED = 6 // Java compiles the code during these rounds, which have 3,000 scans
private const val ROUND_MS = 10_000L
private const val LATE_MS = 500L

/** A scan of 360 rays. The nearest distance is the number, and a command has that number as its speed. */
private val SCANS = Counted("/scan", "/cmd_vel", "\"linear\": ?\\{\"x\"") { number ->
    val ranges = List(360) { ray -> if (ray == 180) number else 1_000_000.125 + ray }
    """{"header":{"seq":$number,"frame_id":"laser"},"range_min":0.1,"range_max":30.0,"ranges":[${ranges.joinToString(",")}]}"""
}

/**
 * Measures the time from a scan until the bridge has its command, for an agent and for a roslibpy client. Agent and client are processes,
 * each with its own bridge. Agent and client get scans alternately, 50 per second.
 *
 * @param python a Python with roslibpy
 * @return true if median and 99th percentile of the agent do not exceed those of the client
 */
internal fun reactions(python: String): Boolean {
    val script = Files.createTempFile("argo-bench", ".py")
    Files.writeString(script, checkNotNull(Reacting::class.java.getResource("/rosbench.py")).readText())
    val agent = Reacting("an agent") { programApart(REACTING_AGENT, "$it") }
    val client = Reacting("roslibpy") {
        ProcessBuilder(python, "$script", "$it").redirectError(ProcessBuilder.Redirect.INHERIT).start()
    }
    agent.use {
        client.use {
            repeat(ROUNDS) { round -> listOf(agent, client).forEach { it.measure(isCounted = round >= UNCOUNTED) } }
        }
    }
    Files.delete(script)
    println("from a scan to the command that it causes, $HZ scans a second:")
    println(agent)
    println(client)
    return listOf(0.5, 0.99).all { agent.times.ms(it) <= client.times.ms(it) }
}

/** The program of the agent's process. Runs the agent with the bridge at the TCP port [number] until the standard input ends. */
internal fun reactingAgent(number: Int): ByteArray = Agents().use {
    it.start(
        "bob",
        """
        !start.
        +!start <- argo.port("ros://127.0.0.1:$number#scanbench"); argo.limit(0); argo.percepts(open).
        +nearest(D) <- argo.act(move(D)).
        """,
    )
    System.`in`.readAllBytes()
}

/** A program that reacts to scans, with its own bridge. [start] starts the program with the port of the bridge. */
private class Reacting(private val name: String, start: (Int) -> Process) : AutoCloseable {
    private val published = ConcurrentHashMap<Int, Long>()
    private val nanos = ConcurrentLinkedQueue<Long>()
    private var scans = 0
    private val bridge = CountingBridge(0, 0, HZ, SCANS) { published[it] = System.nanoTime() }.apply { isCounting = false }
    private val process = start(bridge.number)

    val times: Distribution get() = Distribution(nanos.toLongArray())

    fun measure(isCounted: Boolean) {
        val before = published.size
        bridge.heard = { number -> if (isCounted) nanos += System.nanoTime() - published.getValue(number) }
        bridge.isCounting = true
        Thread.sleep(ROUND_MS)
        bridge.isCounting = false
        Thread.sleep(LATE_MS)
        if (isCounted) scans += published.size - before
    }

    override fun close() {
        process.destroyForcibly().waitFor()
        bridge.close()
    }

    override fun toString(): String {
        val (median, most, longest) = listOf(0.5, 0.99, 1.0).map(times::ms)
        return figures(
            "%s: median %.2f, 99th percentile %.1f, longest %.0f ms; %d of %d scans answered",
            name, median, most, longest, times.size, scans,
        )
    }
}
