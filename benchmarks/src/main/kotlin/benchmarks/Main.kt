package benchmarks

import benchmarks.boards.BOARDS_COURSE
import benchmarks.boards.BOARD_HOST
import benchmarks.boards.MANY_BOARDS
import benchmarks.boards.boards
import benchmarks.boards.boardsCourse
import benchmarks.boards.hostBoards
import benchmarks.boards.manyBoards
import benchmarks.fleet.fleet
import benchmarks.ros.REACTING_AGENT
import benchmarks.ros.reactingAgent
import benchmarks.ros.ros
import benchmarks.stops.stops
import java.io.File
import kotlin.system.exitProcess

/**
 * The benchmarks, by their names. Each takes a file for its results, which some ignore, and more arguments. Each prints its figures. A
 * benchmark returns false if its figures break their bounds.
 */
private val BENCHMARKS: Map<String, (file: File, more: List<String>) -> Any> = mapOf(
    "latency" to { _, _ -> latency() },
    "stops" to { file, _ -> stops(file) },
    "boards" to { file, _ -> boards(file) },
    "filters" to { file, _ -> filters(file) },
    "realtime" to { file, _ -> realtime(file) },
    "bounds" to { _, _ -> bounds() },
    "faults" to { _, _ -> faults() },
    "soak" to { _, _ -> soak() },
    "tls" to { _, _ -> tls() },
    "ros" to { _, more -> ros(more.firstOrNull()) },
    "explore" to { _, _ -> explored() },
    "record" to { _, _ -> recorded() },
    "reload" to { _, _ -> reloaded() },
    "fleet" to { _, rows -> fleet(rows) },
)

/** The programs for [figuresApart] and [programApart], by their names. Each takes arguments and returns its figures. */
private val APART: Map<String, (List<String>) -> List<Number>> = mapOf(
    LATENCY_COURSE to { latencyCourse(it.single()) },
    CROWD to { crowd() },
    REPLAY to ::paces,
    BOARDS_COURSE to { (boards, percepts) -> boardsCourse(boards.toInt(), percepts.toInt()) },
    MANY_BOARDS to { manyBoards() },
)

/** Runs the benchmark of the first argument, and prints its figures. Some benchmarks also write all results to a file. */
fun main(args: Array<String>) {
    val name = args.firstOrNull().orEmpty()
    val rest = args.drop(1)
    when (name) {
        in BENCHMARKS -> {
            val result = BENCHMARKS.getValue(name)(File(rest.firstOrNull() ?: "$name.txt"), rest.drop(1))
            if (result == false) exitProcess(1)
        }
        in APART -> println(APART.getValue(name)(rest).joinToString(" "))
        BOARD_HOST -> hostBoards(rest)
        REACTING_AGENT -> reactingAgent(rest.single().toInt())
        else -> {
            System.err.println("usage: ./argo bench ${BENCHMARKS.keys.joinToString("|")}")
            exitProcess(2)
        }
    }
    exitProcess(0) // Jason's scheduler would keep the process alive
}
