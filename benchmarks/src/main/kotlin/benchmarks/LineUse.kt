package benchmarks

import javino.Protocol
import javino.sim.SimulatedBoards
import java.util.concurrent.atomic.AtomicLong
import java.util.concurrent.atomic.AtomicReference

/**
 * The share of a line's time that an agent with `argo.limit(0)` uses: requests and answers a second, times the line time of both. The board
 * answers at once, with twelve percepts; the line is in memory and gives each byte its time.
 */
internal class LineUse(private val baud: Int, private val protocol: Protocol) {
    private class Seen(val count: Int, val nanos: Long)

    private val bytes = AtomicLong()
    private val latest = AtomicReference(Seen(0, 0))

    /** Measures the share, 0 to 1. */
    fun measure(): Double {
        val board = SensorBoard(
            protocol, SensorBoard::robot,
            object : SensorBoard.Witness {
                override fun answered(n: Int, endNanos: Long, bytes: Int) {
                    this@LineUse.bytes.addAndGet(bytes.toLong())
                    latest.set(Seen(n, endNanos))
                }
            },
        )
        SimulatedBoards.plugIn("line", board)
        try {
            Agents().use { agents ->
                agents.start("senses", "!start.\n+!start <- argo.port(\"sim:line\", [baud($baud)]); argo.limit(0); argo.percepts(open).\n")
                Thread.sleep(WARM_UP_MS)
                val first = latest.get()
                val before = bytes.get()
                Thread.sleep(MEASURED_MS)
                val last = latest.get()
                return (bytes.get() - before) * 10e9 / baud / (last.nanos - first.nanos)
            }
        } finally {
            SimulatedBoards.unplug("line")
        }
    }

    private companion object {
        const val WARM_UP_MS = 3000L
        const val MEASURED_MS = 6000L
    }
}
