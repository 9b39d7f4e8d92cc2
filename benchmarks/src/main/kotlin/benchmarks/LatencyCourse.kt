package benchmarks

import javino.Frame
import javino.FrameDecoder
import javino.LineSettings
import javino.PerceptsRequest
import javino.PortGoneException
import javino.Transport
import javino.Transports
import javino.sim.PseudoTerminals
import kotlin.concurrent.thread

/**
 * A program that answers a board's frames at 50 Hz, in a new Java process. The program answers the percept `ping(N)`, one of twelve, by the
 * command `pong(N)`. The line is a pseudo-terminal of `socat`, used by jSerialComm.
 */
internal enum class LatencyCourse(val title: String) {
    ARGO("an agent with ARGO") {
        override fun run(port: String, measure: () -> LongArray) = agent(
            "argo.Arch", sensing(port, BAUD, INTERVAL_MS, "+ping(N) <- argo.act(pong(N)).\n"), measure,
        )
    },

    ONE_THREAD("an agent on one thread") {
        override fun run(port: String, measure: () -> LongArray): LongArray {
            SingleThread.port = port
            return agent(SingleThread::class.java.name, "+ping(N) <- benchmarks.say(pong(N)).\n", measure)
        }
    },

    /** There is no agent. A thread writes the command as soon as it has read the frame. */
    LINE("the line without an agent") {
        override fun run(port: String, measure: () -> LongArray): LongArray = Transports.open(port, LineSettings(BAUD)).use { computer ->
            thread(isDaemon = true, name = "partner") {
                try {
                    answerPings(computer)
                } catch (_: PortGoneException) { // the course has closed the port
                }
            }
            measure()
        }
    }, ;

    protected abstract fun run(port: String, measure: () -> LongArray): LongArray

    /** Returns the latencies in ns, in order of time. */
    fun measure(exchanges: Int): LongArray = PseudoTerminals.open().use { line ->
        val board = PingBoard(line.board(), exchanges)
        run("${line.computer()}", board::measure)
    }

    companion object {
        const val BAUD = 115_200
        const val INTERVAL_MS = 20
        const val LIMIT_MS = 10_000

        private fun agent(arch: String, program: String, measure: () -> LongArray): LongArray = Agents().use { agents ->
            agents.start("ping", program, arch)
            measure()
        }

        private fun answerPings(computer: Transport) {
            var pings = 0
            val decoder = FrameDecoder(FrameDecoder.interByteTimeoutNanos(computer.line())) { computer.write(Frame.of("pong(${++pings})")) }
            val buffer = ByteArray(512)
            while (true) {
                val before = pings
                computer.write(Frame.of(PerceptsRequest.ALL))
                while (pings == before) decoder.accept(buffer, 0, computer.read(buffer, 0, buffer.size, LIMIT_MS), System.nanoTime())
                Thread.sleep(INTERVAL_MS.toLong()) // agents also wait between requests
            }
        }

        private fun Transport.write(frame: Frame) = frame.toBytes().let { write(it, 0, it.size, LIMIT_MS) }
    }
}
