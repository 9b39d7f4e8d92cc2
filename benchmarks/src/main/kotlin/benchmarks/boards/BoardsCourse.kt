package benchmarks.boards

import benchmarks.Agents
import benchmarks.Distribution
import benchmarks.awaitAtMost
import benchmarks.figuresApart
import javino.sim.PseudoTerminals

/**
 * An agent that senses [boards] boards at 50 Hz over pseudo-terminals, each with so many [percepts], all of which change with each answer.
 * The boards run in another process.
 */
internal data class BoardsCourse(val boards: Int, val percepts: Int) {
    /**
     * The figures of a course.
     *
     * @property leastSensed the sensing rate of the board that was sensed least, as a share of the nominal rate, 0 to 1
     * @property leastPerceived the same for the snapshots that the agent has perceived
     * @property skewMs the median of the skew after each cycle that has perceived something, its 99th percentile and the longest
     * @property processor the share of one processor that the agent's process took
     * @property processorOf that share by groups of threads
     */
    class Result(
        val leastSensed: Double, val leastPerceived: Double, val skewMs: List<Double>, val processor: Double,
        val processorOf: Map<ThreadGroup, Double>,
    )

    /** Measures in a Java machine of its own. */
    fun measure(): Result {
        val figures = figuresApart(NAME, "$boards", "$percepts").iterator()
        return Result(
            figures.next(), figures.next(), List(SHARES.size) { figures.next() }, figures.next(),
            ThreadGroup.entries.associateWith { figures.next() },
        )
    }

    /** The program in that machine: prints the figures. */
    fun run() {
        val lines = List(boards) { PseudoTerminals.open() }
        try {
            BoardHost.onDevices(lines.map { it.board() }, percepts).use { Agents().use { agents -> run(agents, lines) } }
        } finally {
            lines.forEach { it.close() }
        }
    }

    private fun run(agents: Agents, lines: List<PseudoTerminals>) {
        val ports = lines.mapIndexed { i, line -> "port(\"${line.computer()}\",[as(board$i),baud(115200),boot(0)])" }
        agents.start(
            AGENT, "!start.\n+!start <- argo.ports([${ports.joinToString()}]); argo.limit($INTERVAL_MS); argo.percepts(open).\n",
            options = mapOf(BoardWatch.OPTION to "$boards"),
        )
        val watch = BoardWatch.of(AGENT)
        check(awaitAtMost(OPENING_S) { watch.perceived().size == boards }) {
            "only ${watch.perceived().size} of $boards boards are perceived"
        }
        Thread.sleep(WARM_UP_MS)
        watch.takeSkews()
        val sensed = watch.sensed()
        val perceived = watch.perceived()
        val before = ProcessorTimes.now()
        val start = System.nanoTime()
        Thread.sleep(MEASURED_MS)
        val nanos = System.nanoTime() - start
        val used = ProcessorTimes.now() - before
        val due = nanos / 1e6 / INTERVAL_MS
        val skews = Distribution(watch.takeSkews())
        val figures = listOf(least(sensed, watch.sensed()) / due, least(perceived, watch.perceived()) / due) +
            SHARES.map(skews::ms) + (used.process / nanos.toDouble()) + ThreadGroup.entries.map { used.of(it) / nanos.toDouble() }
        println(figures.joinToString(" "))
    }

    private fun least(before: Map<String, Long>, after: Map<String, Long>) =
        after.minOf { (port, count) -> count - before.getOrDefault(port, 0) }

    override fun toString() = "$boards ${if (boards == 1) "board" else "boards"} of $percepts percepts"

    companion object {
        /** The name of the program. */
        const val NAME = "boards-course"

        private const val AGENT = "robot"
        private const val INTERVAL_MS = 20
        private const val OPENING_S = 30
        private const val WARM_UP_MS = 40_000L
        private const val MEASURED_MS = 20_000L
        private val SHARES = listOf(0.5, 0.99, 1.0)
    }
}
