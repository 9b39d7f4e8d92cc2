package benchmarks.boards

import benchmarks.Agents
import benchmarks.figures
import benchmarks.figuresApart
import benchmarks.residentMb
import benchmarks.usedHeap
import jason.runtime.RuntimeServicesFactory
import kotlin.math.abs

internal const val MANY_BOARDS = "many-boards"

/** Measures an agent of 127 network boards in a new Java process. Returns the figures in words. */
internal fun sensedMany(): String {
    val measured = figuresApart(MANY_BOARDS)
    val (leastSensed, lost, messages, heapMb, residentMb) = measured
    val (threads, openingMs, closingMs) = measured.drop(5)
    return figures(
        "$BOARDS boards over TCP at 5 Hz: sensed at %.1f %% of the rate or more; %.0f of %.0f answers lost; heap %.0f MB, %.0f KB a " +
            "board; process %.0f MB; %.0f threads, %.1f a board; all perceived after %.0f ms; closed after %.0f ms",
        leastSensed * 100, lost, messages, heapMb, heapMb * 1024 / BOARDS, residentMb, threads, threads / BOARDS, openingMs, closingMs,
    )
}

/**
 * Measures an agent of 127 network boards, each sensed five times per second. The boards run in another process. Returns, in this order:
 * - the lowest sensing rate of a board, as a share of the nominal rate from 0 to 1
 * - the number of answers that were lost or doubled, and the number of all answers
 * - the heap of the boards after a garbage collection, and the resident memory of the process, both in MB
 * - the number of threads of the boards
 * - the time in ms from `argo.ports` until all boards are perceived, and from the end of the agent until all lines are closed
 */
internal fun manyBoards(): List<Number> = BoardHost.onNetwork(BOARDS, PERCEPTS).use { host -> Agents().use { measure(it, host) } }

private fun measure(agents: Agents, host: BoardHost): List<Number> {
    val ports = host.ports.mapIndexed { i, port -> "port(\"$port\",[as(board$i)])" }
    agents.start(AGENT, program(ports), options = mapOf(BoardWatch.OPTION to "$BOARDS"))
    val watch = BoardWatch.of(AGENT)
    Thread.sleep(SETTLING_MS)
    val heap = usedHeap()
    val threads = Thread.activeCount()
    val opening = System.nanoTime()
    agents.achieve(AGENT, "open")
    watch.awaitAll(LIMIT_S)
    val opened = System.nanoTime()
    Thread.sleep(WARM_UP_MS)
    val before = watch.sensed()
    val start = System.nanoTime()
    Thread.sleep(MEASURED_MS)
    val due = (System.nanoTime() - start) / 1e6 / INTERVAL_MS
    val least = leastMore(before, watch.sensed()) / due
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

private const val BOARDS = 127
private const val AGENT = "robot"
private const val PERCEPTS = 3
private const val INTERVAL_MS = 200
private const val SETTLING_MS = 2_000L
private const val WARM_UP_MS = 10_000L
private const val MEASURED_MS = 20_000L
private const val LIMIT_S = 60
private const val MB = 1024.0 * 1024.0
