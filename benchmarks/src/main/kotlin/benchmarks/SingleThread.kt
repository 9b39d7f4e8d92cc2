package benchmarks

import jason.architecture.AgArch
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import javino.Frame
import javino.FrameDecoder
import javino.LineSettings
import javino.PerceptsRequest
import javino.Transport
import javino.Transports
import java.util.concurrent.TimeUnit

/**
 * A simple architecture for comparison with ARGO's latency. One thread reads, decides and writes. Each reasoning cycle requests percepts,
 * waits for the answer, and parses it with Jason's parser. [say] writes a command at once. The architecture has no filters, only one port,
 * and no fault handling.
 *
 * Set [port] before Jason makes the agent.
 */
class SingleThread : AgArch() {
    private val line: Transport = Transports.open(port, LineSettings(LatencyCourse.BAUD))
    private val messages = ArrayDeque<String>()
    private val decoder = FrameDecoder(FrameDecoder.interByteTimeoutNanos(line.line())) { messages += it.text() }
    private val buffer = ByteArray(512)
    private var lastNanos = System.nanoTime()
    private var percepts: List<Literal> = emptyList()

    override fun perceive(): MutableCollection<Literal>? {
        val left = lastNanos + INTERVAL_NANOS - System.nanoTime()
        if (left > 0) {
            if (ts.c.hasEvent() || ts.c.hasRunningIntention()) return null
            try {
                TimeUnit.NANOSECONDS.sleep(left)
            } catch (_: InterruptedException) { // Jason ends the agent
                Thread.currentThread().interrupt()
                return null
            }
        }
        lastNanos = System.nanoTime()
        percepts = exchange().split(';').filter(String::isNotEmpty).map(ASSyntax::parseLiteral)
        return percepts.toMutableList()
    }

    private fun exchange(): String {
        say(PerceptsRequest.ALL)
        while (messages.isEmpty()) decoder.accept(buffer, 0, line.read(buffer, 0, buffer.size, LatencyCourse.LIMIT_MS), System.nanoTime())
        return messages.removeFirst()
    }

    /** Writes a message on the agent's thread. There is no time limit, since a limit would need another thread. */
    fun say(message: String) = Frame.of(message).toBytes().let { line.write(it, 0, it.size, 0) }

    /** Returns false. The agent never sleeps, since it waits in [perceive]. */
    override fun canSleep() = false

    override fun stop() {
        line.close()
        super.stop()
    }

    companion object {
        private val INTERVAL_NANOS = TimeUnit.MILLISECONDS.toNanos(LatencyCourse.INTERVAL_MS.toLong())

        @Volatile
        var port: String = ""
    }
}
