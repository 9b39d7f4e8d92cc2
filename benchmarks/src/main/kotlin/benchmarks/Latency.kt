package benchmarks

import javino.Frame
import javino.FrameDecoder
import javino.LineSettings
import javino.PerceptsRequest
import javino.Transport
import javino.Transports
import javino.sim.PseudoTerminals
import java.util.Locale
import kotlin.concurrent.thread

private const val EXCHANGES = 1500
private val FIRST_MINUTE = 300 until 300 + EXCHANGES
private val WARM = 3300 until 3300 + EXCHANGES
private const val BAUD = 115_200
private const val INTERVAL_MS = 20L
private const val LIMIT_MS = 10_000

/** How long agents took, while Java still compiles what they do and when it has. */
internal class Latencies(val firstMinute: Distribution, val warm: Distribution)

/**
 * From the last byte of a frame with twelve percepts, written to a pseudo-terminal, to the first byte of the command that it
 * causes: the board's end, `socat`, jSerialComm, the sensing thread, Jason's belief update, event, plan and `argo.act`, and back.
 */
internal fun measureLatency(): Latencies = PseudoTerminals.open().use { line ->
    val board = PingBoard(line.board(), WARM.last + 1)
    Agents().use { agents ->
        agents.start(
            "ping",
            "!start.\n+!start <- argo.port(\"${line.computer()}\", [baud($BAUD)]); argo.limit($INTERVAL_MS); " +
                "argo.percepts(open).\n+ping(N) <- argo.act(pong(N)).\n",
        )
        val latencies = board.measure()
        Latencies(Distribution(latencies.sliceArray(FIRST_MINUTE)), Distribution(latencies.sliceArray(WARM)))
    }
}

/**
 * The same line and the same frames without an agent: a thread that reads the frame through jSerialComm and writes the command at once.
 * What of [measureLatency] is not ARGO's and Jason's.
 */
internal fun measureBareLatency(): Distribution = PseudoTerminals.open().use { line ->
    val board = PingBoard(line.board(), FIRST_MINUTE.last + 1)
    Transports.open("${line.computer()}", LineSettings(BAUD)).use { computer ->
        val partner = thread(isDaemon = true, name = "partner") { answerPings(computer) }
        Distribution(board.measure().sliceArray(FIRST_MINUTE)).also { partner.join() }
    }
}

private fun answerPings(computer: Transport) {
    var pings = 0
    val decoder = FrameDecoder(FrameDecoder.interByteTimeoutNanos(computer.line())) { computer.write(Frame.of("pong(${++pings})")) }
    val buffer = ByteArray(512)
    for (exchange in 1..FIRST_MINUTE.last + 1) {
        computer.write(Frame.of(PerceptsRequest.ALL))
        while (pings < exchange) decoder.accept(buffer, 0, computer.read(buffer, 0, buffer.size, LIMIT_MS), System.nanoTime())
        Thread.sleep(INTERVAL_MS) // as the agent does between requests
    }
}

private fun Transport.write(frame: Frame) = frame.toBytes().let { write(it, 0, it.size, LIMIT_MS) }

/** Measures both and prints the figures. */
fun latency() {
    println("frame to command over a pseudo-terminal, 12 percepts, $EXCHANGES exchanges each, ${machine()}:")
    val agent = measureLatency()
    mapOf(
        "an agent" to agent.warm, "an agent in its first minute" to agent.firstMinute, "the line without an agent" to measureBareLatency(),
    ).forEach { (what, latencies) ->
        println(
            "%-29s median %.3f ms, 99th percentile %.3f ms, longest %.3f ms".format(
                Locale.ROOT, what, latencies.ms(0.5), latencies.ms(0.99), latencies.ms(1.0),
            ),
        )
    }
}
