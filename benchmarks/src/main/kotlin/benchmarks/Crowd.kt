package benchmarks

import javino.Protocol
import javino.sim.SimulatedBoards
import java.util.concurrent.atomic.AtomicLong

/** A thousand agents with a board each in one Java machine, sensing twelve percepts at 10 Hz of which one has changed. */
internal class Crowd {
    /** The answers a second that all agents got together, and the largest resident memory of the process, in MB. */
    class Result(val rate: Double, val residentMb: Double)

    /** Measures in a Java machine of its own that may have [HEAP_MB] MB of heap. */
    fun measure(): Result {
        val figures = figuresApart(NAME, options = listOf("-Xmx${HEAP_MB}m"))
        return Result(figures[0], figures[1])
    }

    /** The program in that machine: prints the two figures. */
    fun run() {
        val answers = AtomicLong()
        val witness = object : SensorBoard.Witness {
            override fun answered(n: Int, endNanos: Long, bytes: Int) {
                answers.incrementAndGet()
            }
        }
        for (i in 1..AGENTS) SimulatedBoards.plugIn("crowd$i", SensorBoard(Protocol.AUTO, ::percepts, witness))
        Agents().use { agents ->
            for (i in 1..AGENTS) agents.start(
                "crowd$i",
                "!start.\n+!start <- argo.port(\"sim:crowd$i\", [baud($BAUD)]); argo.limit(100).\n+!look <- argo.percepts(open).\n",
            )
            for (i in 1..AGENTS) agents.achieve("crowd$i", "look")
            Thread.sleep(WARM_UP_MS)
            val before = answers.get()
            val start = System.nanoTime()
            Thread.sleep(MEASURED_MS)
            val rate = (answers.get() - before) * 1e9 / (System.nanoTime() - start)
            println("$rate ${residentMb("VmHWM")}")
        }
    }

    companion object {
        const val NAME = "crowd"
        const val AGENTS = 1000
        const val HEAP_MB = 400

        /** At this rate the line in memory wakes its reader once a frame, as a driver does, and not for each byte. */
        const val BAUD = 20_000_000
        private val BESIDES = SensorBoard.robot(0).substringAfter(';')

        private fun percepts(n: Int) = "dist(f,${n % 100});$BESIDES"
        private const val WARM_UP_MS = 20_000L
        private const val MEASURED_MS = 10_000L
    }
}
