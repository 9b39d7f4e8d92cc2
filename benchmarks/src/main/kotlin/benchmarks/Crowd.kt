package benchmarks

import javino.Protocol
import javino.SimulatedBoards
import java.io.File
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicLong

/** A thousand agents with a board each in one Java machine, sensing twelve percepts at 10 Hz. */
internal class Crowd {
    /** Answers a second that all agents got together, and the most memory that the process had resident, in MB. */
    class Result(val rate: Double, val residentMb: Double)

    /** Measures in a Java machine of its own that may have [HEAP_MB] MB of heap. */
    fun measure(): Result {
        val java = File(System.getProperty("java.home"), "bin/java").path
        val process = ProcessBuilder(java, "-Xmx${HEAP_MB}m", "-cp", System.getProperty("java.class.path"), "benchmarks.MainKt", NAME)
            .redirectError(ProcessBuilder.Redirect.INHERIT).start()
        val figures = process.inputStream.bufferedReader().readLines().last().split(' ').map(String::toDouble)
        check(process.waitFor(LIMIT_S, TimeUnit.SECONDS) && process.exitValue() == 0) { "the crowd's process ended with ${process.exitValue()}" }
        return Result(figures[0], figures[1])
    }

    /** What runs in that machine: prints the two figures. */
    fun run() {
        val answers = AtomicLong()
        for (i in 1..AGENTS) SimulatedBoards.plugIn("crowd$i", SensorBoard(Protocol.AUTO, SensorBoard::robot, object : SensorBoard.Witness {
            override fun answered(n: Int, endNanos: Long, bytes: Int) {
                answers.incrementAndGet()
            }
        }))
        Agents().use { agents ->
            for (i in 1..AGENTS) agents.start("crowd$i", "!start.\n+!start <- argo.port(\"sim:crowd$i\", [baud(115200)]); argo.limit(100); argo.percepts(open).\n")
            Thread.sleep(WARM_UP_MS)
            val before = answers.get()
            val start = System.nanoTime()
            Thread.sleep(MEASURED_MS)
            val rate = (answers.get() - before) * 1e9 / (System.nanoTime() - start)
            println("$rate ${residentMb()}")
        }
    }

    private fun residentMb(): Double {
        val status = File("/proc/self/status")
        if (!status.exists()) return Double.NaN // Linux alone tells
        return status.readLines().first { it.startsWith("VmHWM") }.filter(Char::isDigit).toDouble() / 1024
    }

    companion object {
        const val NAME = "crowd"
        const val AGENTS = 1000
        const val HEAP_MB = 600
        private const val WARM_UP_MS = 20_000L
        private const val MEASURED_MS = 10_000L
        private const val LIMIT_S = 120L
    }
}
