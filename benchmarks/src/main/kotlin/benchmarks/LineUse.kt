package benchmarks

import javino.Protocol
import java.util.concurrent.atomic.AtomicLong

/**
 * Measures the share of a line's time, from 0 to 1, that an agent with `argo.limit(0)` uses. The share is the number of requests per second
 * times the line time of a request and its answer. The board answers at once, with twelve percepts. The line is in memory, and each byte
 * takes its real time. [options] are more options of the port, each behind a comma.
 */
internal fun lineUse(baud: Int, protocol: Protocol, options: String = ""): Double {
    val bytes = AtomicLong()
    val latestNanos = AtomicLong()
    val board = SensorBoard(
        protocol, SensorBoard::robot,
        { _, endNanos, count ->
            bytes.addAndGet(count.toLong())
            latestNanos.set(endNanos)
        },
    )
    return withAgents(mapOf("line" to board)) { agents ->
        agents.start("senses", sensing("sim:line", baud, intervalMs = 0, options = options))
        Thread.sleep(WARM_UP_MS)
        val firstNanos = latestNanos.get()
        val before = bytes.get()
        Thread.sleep(MEASURED_MS)
        (bytes.get() - before) * 10e9 / baud / (latestNanos.get() - firstNanos)
    }
}

private const val WARM_UP_MS = 3000L
private const val MEASURED_MS = 6000L
