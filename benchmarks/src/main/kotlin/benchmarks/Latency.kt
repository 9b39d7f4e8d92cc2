package benchmarks

import jason.infra.local.RunLocalMAS
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import javino.PseudoTerminals
import java.io.File
import java.nio.file.Path
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText

private const val WARM_UP = 300
private const val EXCHANGES = 1500

/**
 * From the last byte of a frame with twelve percepts, written to a pseudo-terminal, to the first byte of the command that it
 * causes: the board's end, `socat`, jSerialComm, the sensing thread, Jason's belief update, event, plan and `argo.act`, and back.
 */
fun latency() {
    PseudoTerminals.open().use { line ->
        val board = PingBoard(line.board(), WARM_UP + EXCHANGES)
        val directory = createTempDirectory("argo-bench")
        val mas = startAgent(directory, line.computer())
        val latencies = board.measure().drop(WARM_UP).sorted()
        mas.finish(0, false, 0)
        directory.toFile().deleteRecursively()
        fun ms(share: Double) = latencies[((latencies.size - 1) * share).toInt()] / 1e6
        println("frame to command over a pseudo-terminal, 12 percepts, ${latencies.size} exchanges after $WARM_UP to warm up, ${machine()}:")
        println("median %.3f ms, 99th percentile %.3f ms, longest %.3f ms".format(ms(0.5), ms(0.99), ms(1.0)))
    }
}

private fun startAgent(directory: Path, port: File): RunLocalMAS {
    val program = directory.resolve("ping.asl").apply {
        writeText("!start.\n+!start <- argo.port(\"$port\", [baud(115200)]); argo.limit(20); argo.percepts(open).\n+ping(N) <- argo.act(pong(N)).\n")
    }
    val logging = directory.resolve("logging.properties").apply { writeText("handlers = java.util.logging.ConsoleHandler\n.level = WARNING\n") }
    val mas = RunLocalMAS()
    mas.init(arrayOf("--empty-mas", "--no-net", "--log-conf", logging.toString()))
    mas.create()
    mas.start()
    val agent = RuntimeServicesFactory.get().createAgent("ping", program.toString(), null, listOf("argo.Arch"), null, Settings(), null)
    RuntimeServicesFactory.get().startAgent(agent)
    return mas
}
