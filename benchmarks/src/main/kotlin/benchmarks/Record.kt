package benchmarks

import argo.recording.replay.Recording
import argo.recording.replay.Replay
import javino.sim.SimulatedBoards
import javino.sim.Sketch
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicInteger
import kotlin.io.path.createTempDirectory

/** The first argument of a program of its own that replays recordings. */
internal const val REPLAY = "replay-recordings"

/**
 * What a recording costs an agent that perceives twelve percepts 50 times a second, which all change, and answers each time with a command:
 * drives without a recording and with one, in turn. Prints the processor time of the agent's thread in a cycle, the size of the recordings
 * and how fast they are replayed. Returns whether all is within its bounds.
 */
internal fun recorded(): Boolean {
    println("machine: ${machine()}")
    val folder = createTempDirectory("argo-bench-record")
    listOf(null, folder.resolve("warm-up.mcap")).forEach { drive(it, WARM_UP_MS) } // as fast as it goes, so that Java has compiled all
    val files = (1..DRIVES).map { folder.resolve("drive-$it.mcap") }
    val (without, with) = files.map { drive(null) to drive(it) }.unzip().run { Cycles(first.flatten()) to Cycles(second.flatten()) }
    println("cycle without a recording: $without")
    println("cycle with a recording:    $with")
    val cost = with.meanNs / without.meanNs - 1
    println("the recording costs %.1f %% of it in the mean, at most $MOST_COST".format(cost * 100))
    val megabytes = files.sumOf(Files::size) / 1e6 / (DRIVES * DRIVE_S) * 60
    println("%.2f MB a minute at %.0f messages of its board a second, at most $MOST_MEGABYTES".format(megabytes, rate(files)))
    val paces = figuresApart(REPLAY, *files.map { "$it" }.toTypedArray())
    val all = paces.joinToString { "%.0f".format(it) }
    println("replayed at so many times real time, the first one by a Java that has just started: $all, at least $LEAST_PACE")
    folder.toFile().deleteRecursively()
    return cost * 100 <= MOST_COST && megabytes <= MOST_MEGABYTES && paces.min() >= LEAST_PACE
}

/** Replays [files] in turn, and prints how many times faster than real time each was. */
internal fun replayRecordings(files: List<String>) = println(files.joinToString(" ") { "${pace(Path.of(it))}" })

private fun pace(file: Path): Double {
    val begin = System.nanoTime()
    return Recording(file).use { recording ->
        Replay(recording).use { replay ->
            val firstNs = checkNotNull(replay.nextNs) { "$file holds no cycle" }
            replay.run()
            check(replay.differences.isEmpty()) { replay.differences.first() }
            (checkNotNull(replay.lastNs) - firstNs).toDouble() / (System.nanoTime() - begin)
        }
    }
}

/** How many messages of the board the agent perceived in a second. */
private fun rate(files: List<Path>): Double = files.sumOf { file ->
    Recording(file).use { recording ->
        recording.agents.keys.sumOf { agent -> recording.cycles(agent).sumOf { it.input.snapshots.size } }
    }
}.toDouble() / (DRIVES * DRIVE_S)

/**
 * The processor time of the agent's cycles in ns, when it drives for [DRIVE_S], asks its board each [intervalMs], and is recorded to [file];
 * null: it is not.
 */
private fun drive(file: Path?, intervalMs: Int = INTERVAL_MS): List<Long> {
    val times = ArrayList<Long>()
    TimedArch.times = times
    SimulatedBoards.plugIn(BOARD, Changing())
    try {
        Agents().use { agents ->
            val options = if (file == null) emptyMap() else mapOf("argo_record" to "$file")
            agents.start("driver", program(intervalMs), TimedArch::class.java.name, options)
            Thread.sleep(DRIVE_S * 1_000L)
        }
    } finally {
        SimulatedBoards.unplug(BOARD)
        TimedArch.times = null
    }
    return times.drop(times.size / LOADING)
}

/** A board whose twelve percepts are others each time. */
private class Changing : Sketch {
    private val requests = AtomicInteger()

    override fun percepts(): List<String> = SensorBoard.robot(requests.incrementAndGet()).split(';').filter(String::isNotEmpty)

    override fun act(command: String) = true
}

private class Cycles(nanos: List<Long>) {
    private val sorted = nanos.sorted()
    val meanNs = sorted.average()

    override fun toString() = "median %.0f µs, mean %.0f µs, of %d".format(sorted[sorted.size / 2] / 1e3, meanNs / 1e3, sorted.size)
}

private fun program(intervalMs: Int) =
    """
    !start.
    +!start <- argo.port("sim:$BOARD", [baud(115200)]); argo.limit($intervalMs); argo.percepts(open).
    +dist(f,Cm) : Cm < 60 <- argo.act(stop).
    +dist(f,Cm) <- argo.act(forward).
    """.trimIndent()

private const val BOARD = "bench-record"
private const val INTERVAL_MS = 20
private const val WARM_UP_MS = 1
private const val DRIVES = 3
private const val DRIVE_S = 10
private const val LOADING = 6 // a sixth of a drive: classes are loaded and the port is opened
private const val MOST_COST = 5
private const val MOST_MEGABYTES = 2
private const val LEAST_PACE = 30
