package benchmarks.boards

import benchmarks.Agents
import benchmarks.Distribution
import benchmarks.figures
import benchmarks.figuresApart
import javino.sim.PseudoTerminals

internal const val BOARDS_COURSE = "boards-course"

internal fun senseSeveral() {
    println("pseudo-terminals, all percepts change, 50 Hz, 20 s after 40 s; boards in another process")
    var one = Double.NaN
    for ((boards, percepts) in listOf(1 to 12, 8 to 3, 8 to 12)) {
        val measured = figuresApart(BOARDS_COURSE, "$boards", "$percepts")
        val (leastSensed, leastPerceived, processor) = measured
        val skewsMs = measured.drop(3).take(SHARES.size)
        val groups = ThreadGroup.entries.zip(measured.drop(3 + SHARES.size)).joinToString { (group, share) ->
            figures("%s %.1f %%", group.title, share * 100)
        }
        if (boards == 1) one = processor
        println(
            figures(
                "%-28s sensed at %.1f %% of the rate or more, perceived at %.1f %%; " +
                    "skew: median %.2f ms, 99th percentile %.2f ms, longest %.1f ms",
                "$boards ${if (boards == 1) "board" else "boards"} of $percepts percepts:", leastSensed * 100, leastPerceived * 100,
                *skewsMs.toTypedArray(),
            ),
        )
        println(figures("%-28s %.1f %% of a processor, %.1f times that of the first: %s", "", processor * 100, processor / one, groups))
    }
}

/**
 * Measures an agent that senses [boards] boards at 50 Hz over pseudo-terminals. Each board has [percepts] percepts, and all change in each
 * answer. The boards run in another process. Returns, in this order:
 * - the lowest sensing rate of a board, as a share of 50 Hz from 0 to 1, and the lowest rate of perceived snapshots
 * - the share of one processor that the agent's process used
 * - the quantiles for [SHARES] of the skew in [BoardWatch], in ms
 * - the share of one processor that each [ThreadGroup] used
 */
internal fun boardsCourse(boards: Int, percepts: Int): List<Double> {
    val lines = List(boards) { PseudoTerminals.open() }
    try {
        return BoardHost.onDevices(lines.map { it.board() }, percepts).use { Agents().use { agents -> measure(agents, lines) } }
    } finally {
        lines.forEach { it.close() }
    }
}

private fun measure(agents: Agents, lines: List<PseudoTerminals>): List<Double> {
    val ports = lines.mapIndexed { i, line -> "port(\"${line.computer()}\",[as(board$i),baud(115200),boot(0)])" }
    agents.start(
        AGENT, "!start.\n+!start <- argo.ports([${ports.joinToString()}]); argo.limit($INTERVAL_MS); argo.percepts(open).\n",
        options = mapOf(BoardWatch.OPTION to "${lines.size}"),
    )
    val watch = BoardWatch.of(AGENT)
    watch.awaitAll(OPENING_S)
    Thread.sleep(WARM_UP_MS)
    watch.takeSkews()
    val sensed = watch.sensed()
    val perceived = watch.perceived()
    val before = ProcessorTimes.now()
    val start = System.nanoTime()
    Thread.sleep(MEASURED_MS)
    val nanos = (System.nanoTime() - start).toDouble()
    val used = ProcessorTimes.now() - before
    val due = nanos / 1e6 / INTERVAL_MS
    val skews = Distribution(watch.takeSkews())
    return listOf(leastMore(sensed, watch.sensed()) / due, leastMore(perceived, watch.perceived()) / due, used.process / nanos) +
        SHARES.map(skews::ms) + ThreadGroup.entries.map { used.of(it) / nanos }
}

private const val AGENT = "robot"
private const val INTERVAL_MS = 20
private const val OPENING_S = 30
private const val WARM_UP_MS = 40_000L
private const val MEASURED_MS = 20_000L
private val SHARES = listOf(0.5, 0.99, 1.0)
