package benchmarks

import javino.PseudoTerminals

private const val WARM_UP = 300
private const val EXCHANGES = 1500

/**
 * From the last byte of a frame with twelve percepts, written to a pseudo-terminal, to the first byte of the command that it
 * causes: the board's end, `socat`, jSerialComm, the sensing thread, Jason's belief update, event, plan and `argo.act`, and back.
 */
internal fun measureLatency(): Distribution = PseudoTerminals.open().use { line ->
    val board = PingBoard(line.board(), WARM_UP + EXCHANGES)
    Agents().use { agents ->
        agents.start("ping", "!start.\n+!start <- argo.port(\"${line.computer()}\", [baud(115200)]); argo.limit(20); argo.percepts(open).\n+ping(N) <- argo.act(pong(N)).\n")
        Distribution(board.measure().drop(WARM_UP).toLongArray())
    }
}

/** Measures it and prints the figures. */
fun latency() {
    val latencies = measureLatency()
    println("frame to command over a pseudo-terminal, 12 percepts, ${latencies.size} exchanges after $WARM_UP to warm up, ${machine()}:")
    println("median %.3f ms, 99th percentile %.3f ms, longest %.3f ms".format(latencies.ms(0.5), latencies.ms(0.99), latencies.ms(1.0)))
}
