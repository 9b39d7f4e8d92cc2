package benchmarks

import argo.Arch
import argo.platform.Platform
import argo.recording.replay.Recording
import argo.recording.replay.Replay
import javino.sim.Sketch
import java.lang.management.ManagementFactory
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicInteger
import kotlin.io.path.createTempDirectory
import kotlin.system.measureNanoTime

internal const val REPLAY = "replay-recordings"

/**
 * Measures the cost of a recording. The agent perceives twelve changing percepts 50 times per second, and answers each time with a command.
 * Drives with and without a recording alternate. Prints the processor time of the agent's thread per cycle and per message. Only the time
 * per message can be compared, since a recorded agent has other cycles. Also prints the processor time of the recording thread, the size of
 * the recordings, and the speed of their replay. No cycle waits for the recording thread. Returns true if all figures keep their bounds.
 */
internal fun recorded(): Boolean {
    println("machine: ${machine()}")
    val folder = createTempDirectory("argo-bench-record")
    listOf(null, folder.resolve("warm-up.mcap")).forEach { drive(it, intervalMs = WARM_UP_MS) } // Java compiles the code during the warm-up
    val files = (1..DRIVES).map { folder.resolve("drive-$it.mcap") }
    val (without, with) = files.map { drive(null) to drive(it) }.unzip().run { Cycles(first) to Cycles(second) }
    println("without a recording: $without")
    println("with a recording:    $with")
    val cost = with.messageNs / without.messageNs - 1
    println(figures("it costs %.1f %% of the agent's time for a message, median of $DRIVES drives, at most $MOST_COST", cost * 100))
    println(figures("besides, the thread that writes it takes %.0f µs for a message", with.writingNs / 1e3))
    val minute = folder.resolve("minute.mcap")
    val messages = drive(minute, MINUTE_S).messages / MINUTE_S.toDouble()
    val megabytes = Files.size(minute) / 1e6 / (LOADING_S + MINUTE_S) * 60
    println(figures("%.2f MB a minute at %.0f messages of its board a second, at most $MOST_MEGABYTES", megabytes, messages))
    val warm = figuresApart(REPLAY, *files.map { "$it" }.toTypedArray()).joinToString { figures("%.0f", it) }
    println("drives of ${LOADING_S + DRIVE_S} s, in turn in one Java, replayed at so many times real time: $warm")
    val pace = paceApart(minute)
    println(figures("a drive of a minute, with the start of Java: replayed at %.0f times real time, at least $LEAST_PACE", pace))
    folder.toFile().deleteRecursively()
    return cost * 100 <= MOST_COST && megabytes <= MOST_MEGABYTES && pace >= LEAST_PACE
}

/**
 * Returns the speed of a replay of [file] in a new Java process, relative to real time. The time includes the start of the process. The
 * replay is started as the tool `replay` starts it.
 */
private fun paceApart(file: Path): Double {
    val elapsedNs = measureNanoTime { figuresApart(REPLAY, "$file", options = listOf("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC")) }
    val times = Recording(file).use { recording -> recording.cycles(recording.agents.keys.single()).map { it.ns }.toList() }
    return (times.last() - times.first()).toDouble() / elapsedNs
}

/** Replays [files] one by one. Returns the speed of each replay, relative to real time. */
internal fun paces(files: List<String>): List<Double> = files.map { pace(Path.of(it)) }

private fun pace(file: Path): Double {
    val begin = System.nanoTime()
    return Recording(file).use { recording ->
        Replay(recording, isChecking = true).use { replay -> // the agent's architecture belongs to this benchmark
            val firstNs = checkNotNull(replay.nextNs) { "$file holds no cycle" }
            replay.run()
            check(replay.differences.isEmpty()) { replay.differences.first() }
            (checkNotNull(replay.lastNs) - firstNs).toDouble() / (System.nanoTime() - begin)
        }
    }
}

/**
 * Processor times in ns: those of the agent's cycles, and that of the thread that writes the recording. [messages] is the number of the
 * board's messages in these cycles.
 */
private class Drive(val cycles: List<Long>, val messages: Int, val writingNs: Long)

/** Returns the processor time of the recording thread, or 0 if there is none. */
private fun writingNs(): Long {
    val threads = ManagementFactory.getThreadMXBean()
    return threads.getThreadInfo(threads.allThreadIds).filterNotNull().filter { it.threadName.startsWith(WRITER) }
        .sumOf { threads.getThreadCpuTime(it.threadId) }
}

/**
 * Runs an agent that requests percepts every [intervalMs]. Measures [seconds] after [LOADING_S]. Records the agent to [file], or makes no
 * recording if [file] is null.
 */
private fun drive(file: Path?, seconds: Int = DRIVE_S, intervalMs: Int = INTERVAL_MS): Drive {
    val times = ArrayList<Long>()
    val board = Changing()
    var before = 0
    var writing = 0L
    withAgents(mapOf(BOARD to board)) { agents ->
        val options = if (file == null) emptyMap() else mapOf("argo_record" to "$file")
        agents.start("driver", program(intervalMs), TimedArch::class.java.name, options)
        Thread.sleep(LOADING_S * 1_000L)
        before = board.messages
        writing = -writingNs()
        TimedArch.times = times
        Thread.sleep(seconds * 1_000L)
        writing += writingNs()
    }
    TimedArch.times = null
    return Drive(times, board.messages - before, writing)
}

/** An architecture that measures its reasoning cycles in [times]. */
class TimedArch(platform: Platform) : Arch(platform) {
    private var begunNs = 0L

    constructor() : this(Platform.system)

    override fun reasoningCycleStarting() {
        begunNs = threads.currentThreadCpuTime
        super.reasoningCycleStarting()
    }

    override fun reasoningCycleFinished() {
        super.reasoningCycleFinished()
        times?.add(threads.currentThreadCpuTime - begunNs)
    }

    companion object {
        private val threads = ManagementFactory.getThreadMXBean()

        /** The processor time of each cycle in ns, or null if nothing is measured. Read this list only while no agent runs. */
        @Volatile
        var times: MutableList<Long>? = null
    }
}

private class Changing : Sketch {
    private val requests = AtomicInteger()

    val messages: Int get() = requests.get()

    override fun percepts(): List<String> = SensorBoard.robot(requests.incrementAndGet()).split(';').filter(String::isNotEmpty)

    override fun act(command: String) = true
}

private class Cycles(drives: List<Drive>) {
    private val sorted = drives.flatMap { it.cycles }.sorted()
    private val cyclesOfMessage = sorted.size.toDouble() / drives.sumOf { it.messages }

    val messageNs = drives.map { it.cycles.sum().toDouble() / it.messages }.sorted()[drives.size / 2]

    val writingNs = drives.map { it.writingNs.toDouble() / it.messages }.sorted()[drives.size / 2]

    override fun toString() = figures(
        "%.0f µs for a message, in %.1f cycles; a cycle has a median of %.0f µs and a mean of %.0f µs, of %d",
        messageNs / 1e3, cyclesOfMessage, sorted[sorted.size / 2] / 1e3, sorted.average() / 1e3, sorted.size,
    )
}

private fun program(intervalMs: Int) = sensing(
    "sim:$BOARD", baud = 115_200, intervalMs, "+dist(f,Cm) : Cm < 60 <- argo.act(stop).\n+dist(f,Cm) <- argo.act(forward).",
)

private const val BOARD = "bench-record"
private const val WRITER = "argo-recording-" // the name of the file follows
private const val INTERVAL_MS = 20
private const val WARM_UP_MS = 1
private const val DRIVES = 3
private const val DRIVE_S = 8
private const val LOADING_S = 2 // classes are loaded and the port is opened in this time
private const val MINUTE_S = 60
private const val MOST_COST = 5
private const val MOST_MEGABYTES = 2
private const val LEAST_PACE = 30
