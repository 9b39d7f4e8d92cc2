package benchmarks.boards

import benchmarks.Agents
import benchmarks.awaitAtMost
import benchmarks.figuresApart
import benchmarks.residentMb
import benchmarks.usedHeap
import jason.runtime.RuntimeServicesFactory
import kotlin.math.abs

/** An agent of 127 boards on the network, each sensed five times a second; the boards run in another process. */
internal class ManyBoards {
    /**
     * The figures of a run.
     *
     * @property leastSensed the sensing rate of the board that was sensed least, as a share of the nominal rate, 0 to 1
     * @property lost the answers of boards that the agent did not get, or got twice
     * @property messages the answers of all boards
     * @property heapMb the heap that the boards take, without garbage, in MB
     * @property residentMb the resident memory of the process, in MB
     * @property threads the number of threads that the boards take
     * @property openingMs the time from `argo.ports` until all boards have been perceived
     * @property closingMs the time from the agent's end until the boards see all lines closed
     */
    class Result(
        val leastSensed: Double, val lost: Int, val messages: Int, val heapMb: Double, val residentMb: Double, val threads: Int,
        val openingMs: Double, val closingMs: Double,
    )

    /** Measures in a Java machine of its own. */
    fun measure(): Result {
        val figures = figuresApart(NAME).iterator()
        return with(figures) { Result(next(), next().toInt(), next().toInt(), next(), next(), next().toInt(), next(), next()) }
    }

    /** The program in that machine: prints the figures. */
    fun run() = BoardHost.onNetwork(BOARDS, PERCEPTS).use { host ->
        Agents().use { agents -> println(run(agents, host).joinToString(" ")) }
    }

    private fun run(agents: Agents, host: BoardHost): List<Number> {
        val ports = host.ports.mapIndexed { i, port -> "port(\"$port\",[as(board$i)])" }
        agents.start(AGENT, program(ports), options = mapOf(BoardWatch.OPTION to "$BOARDS"))
        val watch = BoardWatch.of(AGENT)
        Thread.sleep(SETTLING_MS)
        val heap = usedHeap()
        val threads = Thread.activeCount()
        val opening = System.nanoTime()
        agents.achieve(AGENT, "open")
        check(awaitAtMost(LIMIT_S) { watch.perceived().size == BOARDS }) {
            "only ${watch.perceived().size} of $BOARDS boards are perceived"
        }
        val opened = System.nanoTime()
        Thread.sleep(WARM_UP_MS)
        val before = watch.sensed()
        val start = System.nanoTime()
        Thread.sleep(MEASURED_MS)
        val due = (System.nanoTime() - start) / 1e6 / INTERVAL_MS
        val least = watch.sensed().minOf { (port, count) -> count - before.getValue(port) } / due
        val threadsMore = Thread.activeCount() - threads
        val heapMore = (usedHeap() - heap) / MB
        agents.achieve(AGENT, "pause")
        Thread.sleep(SETTLING_MS)
        val answered = host.ports.zip(host.answered()).toMap()
        val sensed = watch.sensed()
        val lost = answered.entries.sumOf { (port, count) -> abs(count - (sensed[port] ?: 0)) }
        return listOf(
            least, lost, answered.values.sum(), heapMore, residentMb("VmRSS"), threadsMore, (opened - opening) / 1e6, closingMs(host),
        )
    }

    private fun closingMs(host: BoardHost): Double {
        val start = System.nanoTime()
        RuntimeServicesFactory.get().killAgent(AGENT, "bench", 0)
        while (host.openLines() > 0) check(System.nanoTime() - start < LIMIT_S * 1_000_000_000L) { "${host.openLines()} lines remain open" }
        return (System.nanoTime() - start) / 1e6
    }

    private fun program(ports: List<String>) = """
        +!open  <- argo.limit($INTERVAL_MS); argo.percepts(open); argo.ports([${ports.joinToString()}]).
        +!pause <- argo.percepts(block).
    """

    companion object {
        /** The name of the program. */
        const val NAME = "many-boards"
        const val BOARDS = 127

        private const val AGENT = "robot"
        private const val PERCEPTS = 3
        private const val INTERVAL_MS = 200
        private const val SETTLING_MS = 2_000L
        private const val WARM_UP_MS = 10_000L
        private const val MEASURED_MS = 20_000L
        private const val LIMIT_S = 60
        private const val MB = 1024.0 * 1024.0
    }
}
