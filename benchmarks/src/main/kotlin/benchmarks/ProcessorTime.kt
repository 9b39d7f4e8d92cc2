package benchmarks

import javino.LineSettings
import javino.PortException
import javino.Protocol
import javino.Transports
import javino.sim.PseudoTerminals
import java.lang.management.ManagementFactory
import kotlin.concurrent.thread

/**
 * Measures the share of one processor that this program uses, without the threads of its board. An agent senses twelve changing percepts at
 * 50 Hz over a pseudo-terminal. [speaks] is the protocol version of the board.
 */
internal fun processorShare(speaks: Protocol): Double = PseudoTerminals.open().use { line ->
    val board = thread(isDaemon = true, name = "board") { runBoard("${line.board()}", speaks) }
    Agents().use { agents ->
        agents.start("senses", sensing("${line.computer()}", baud = 115_200, intervalMs = 20))
        Thread.sleep(WARM_UP_MS)
        val before = processorNanos(board)
        val start = System.nanoTime()
        Thread.sleep(MEASURED_MS)
        (processorNanos(board) - before).toDouble() / (System.nanoTime() - start)
    }
}

private fun runBoard(port: String, speaks: Protocol) {
    try {
        Transports.open(port, LineSettings(115_200)).use { SensorBoard(speaks, SensorBoard::robot).run(it) }
    } catch (gone: PortException) {
        println("the board ends: ${gone.message}")
    }
}

private fun processorNanos(without: Thread): Long = processNanos() - ManagementFactory.getThreadMXBean().getThreadCpuTime(without.id)

private const val WARM_UP_MS = 60_000L
private const val MEASURED_MS = 10_000L
