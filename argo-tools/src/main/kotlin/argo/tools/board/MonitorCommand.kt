package argo.tools.board

import argo.filters.matching.perceptsOf
import argo.filters.matching.whyClaimed
import argo.filters.matching.whyUnreadable
import argo.filters.withControlsShown
import argo.tools.command.DataCommand
import argo.tools.command.ExitStatus
import argo.tools.command.jsonOf
import argo.tools.command.making
import argo.tools.command.requireNew
import argo.tools.command.requireWithin
import javino.PerceptKind
import javino.PerceptTerm
import javino.PerceptsRequest
import javino.PortException
import javino.PortInterruptedException
import javino.PortTimeoutException
import javino.sim.LineRecording.Direction
import javino.sim.RecordingWriter
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.LockSupport

@Command(
    name = "monitor",
    description = [
        "Shows the percepts of a board as they arrive, and at the end the rate of each. Ctrl-C ends it.",
        "Percepts that no agent believes, or that are not as the board describes them, are marked with (!), and the reason is " +
            "printed once.",
        "Opening a port resets most boards.",
    ],
)
internal class MonitorCommand : DataCommand() {
    @Mixin
    private lateinit var line: LineOptions

    @Parameters(index = "0", paramLabel = "PORT", description = ["ttyACM0, COM8, /dev/pts/3, replay:FILE, ros://robot:9090"])
    private lateinit var port: String

    @Option(
        names = ["--interval"], paramLabel = "MS", defaultValue = "500",
        description = ["from one request to the next, milliseconds; 0: as fast as the line allows (\${DEFAULT-VALUE})"],
    )
    private var intervalMs = 0

    @Option(
        names = ["--mode"], paramLabel = "MODE", defaultValue = "request",
        description = ["request: requests percepts; listen: for a board that sends them unasked (\${DEFAULT-VALUE})"],
    )
    private lateinit var mode: String

    @Option(names = ["--raw"], description = ["shows the bytes that come, whatever they are, and sends nothing"])
    private var raw = false

    @Option(names = ["--record"], paramLabel = "FILE", description = ["records all messages in a new file, for replay and replay:FILE"])
    private var record: Path? = null

    @Option(names = ["--count"], paramLabel = "N", description = ["ends after N messages"])
    private var count: Int? = null

    @Option(names = ["--seconds"], paramLabel = "S", description = ["ends after S seconds"])
    private var seconds: Int? = null

    override fun call(): Int {
        val asks = mode == "request"
        if (!asks && mode != "listen") misuse("--mode is request or listen, not $mode")
        spec.requireWithin("--interval", intervalMs, 0..MAX_MS, "ms")
        if ((count ?: 1) < 1) misuse("--count is at least 1, not $count")
        if ((seconds ?: 1) < 1) misuse("--seconds is at least 1, not $seconds")
        if (raw && (record != null || json)) misuse("--raw goes with neither --record nor --json")
        if (raw) return Interruption().use { line.openRaw(port).use { RawMonitor(it, out, paint).run(count, seconds) } }
        record?.let(::requireNew) // fails before the port is opened, since opening resets the board
        return Interruption().use {
            val elsewhere = line.openElsewhere(port)
            if (elsewhere != null) elsewhere.use { monitorRecording(LinkedBoard(it, intervalMs, line.timeoutMs)) }
            else line.open(port).use { monitorRecording(JavinoBoard(it, asks, line.timeoutMs)) }
        }
    }

    private fun monitorRecording(board: MonitoredBoard): Int {
        val file = record ?: return Run(board, null).untilEnd()
        val writer = making(file) { Files.newBufferedWriter(it, Charsets.UTF_8, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE) }
        return RecordingWriter(writer, System.nanoTime()).use { Run(board, it).untilEnd() }
    }

    private inner class Run(private val board: MonitoredBoard, private val recording: RecordingWriter?) {
        private val start = System.nanoTime()
        private val rates = Rates()
        private var seen = emptySet<String>()
        private val explained = HashSet<String>()
        private var kinds: List<PerceptKind>? = null
        private var unanswered = 0
        private val silences = HashSet<String>()

        fun untilEnd(): Int {
            val status = try {
                while (!isOver()) message()
                if (rates.messages == 0L) ExitStatus.FAILED else ExitStatus.DONE
            } catch (_: PortInterruptedException) {
                ExitStatus.DONE
            } catch (trouble: PortException) {
                err.println(withControlsShown(trouble.message.orEmpty()))
                ExitStatus.FAILED
            } catch (unwritable: IOException) {
                err.println("$record cannot be written: ${unwritable.message}")
                ExitStatus.FAILED
            }
            Thread.interrupted() // Ctrl-C must not interrupt the summary
            summary()
            return status
        }

        private fun isOver(): Boolean {
            val limitMs = seconds?.let { TimeUnit.SECONDS.toMillis(it.toLong()) }
            return out.checkError() || rates.messages >= (count ?: Int.MAX_VALUE) || limitMs != null && ms() >= limitMs
        }

        private fun ms() = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - start)

        private fun message() {
            val begun = System.nanoTime()
            try {
                if (board.isAsked) recording?.add(System.nanoTime(), Direction.OUT, PerceptsRequest.ALL)
                val text = board.next()
                recording?.add(System.nanoTime(), Direction.IN, text)
                val described = kinds ?: describedKinds().also { kinds = it }
                show(text, described)
            } catch (late: PortTimeoutException) {
                if (board.isAsked) show(late) else tellOnce(late)
            }
            if (board.isAsked) waitUntil(begun + TimeUnit.MILLISECONDS.toNanos(intervalMs.toLong()))
        }

        private fun tellOnce(silence: PortTimeoutException) {
            val reason = withControlsShown(silence.message.orEmpty())
            if (silences.add(reason)) err.println("$reason; monitor goes on waiting for percepts")
        }

        private fun describedKinds(): List<PerceptKind> {
            val described = board.kinds()
            described.trouble?.let { err.println("kinds of percepts: ${withControlsShown(it)}") }
            return described.kinds
        }

        private fun waitUntil(nanos: Long) {
            while (nanos - System.nanoTime() > 0 && !isOver()) {
                LockSupport.parkNanos(minOf(nanos - System.nanoTime(), TimeUnit.MILLISECONDS.toNanos(MAX_PAUSE_MS)))
                if (Thread.currentThread().isInterrupted) throw PortInterruptedException(port)
            }
        }

        private fun show(text: String, kinds: List<PerceptKind>) {
            val ms = ms()
            val percepts = perceptsOf(text).map { Shown(it, kinds) }
            rates.count(ms, percepts.map { it.text })
            if (json) return out.println(json(ms, percepts))
            val rate = rates.now()?.let { "${Rates.decimal(it)}/s" } ?: "-"
            val shown = percepts.joinToString("  ") {
                val words = withControlsShown(it.words)
                if (it.problem != null) paint.bad("$words (!)") else if (it.text in seen) words else paint.new(words)
            }
            out.println("${paint.aside("${time(ms)} ${rate.padStart(RATE_WIDTH)}")}  ${shown.ifEmpty { "(no percepts)" }}")
            seen = percepts.map { it.text }.toSet()
            percepts.asSequence().mapNotNull { it.problem }.filter { explained.size < MAX_EXPLAINED && explained.add(it) }.forEach {
                out.println(paint.doubtful("            ${withControlsShown(it)}"))
                if (explained.size == MAX_EXPLAINED) out.println(paint.doubtful("            further percepts with (!) are not explained"))
            }
        }

        private fun json(ms: Long, percepts: List<Shown>) = jsonOf(
            "ms" to ms,
            "percepts" to percepts.map { it.text },
            "unreadable" to percepts.filter { it.whyUnbelieved != null }.map { it.text },
            "deviating" to percepts.filter { it.deviation != null }.map { it.text },
        )

        private fun show(late: PortTimeoutException) {
            unanswered++
            if (json) return out.println(jsonOf("ms" to ms(), "timeout" to late.message))
            out.println("${paint.aside(time(ms()))}  ${paint.doubtful(withControlsShown(late.message.orEmpty()))}")
        }

        private fun time(ms: Long) = "${Rates.seconds(ms).padStart(TIME_WIDTH)} s"

        private fun summary() {
            val damaged = board.damaged
            if (json) return out.println(jsonOf("summary" to summaryOf(damaged)))
            out.println()
            rates.summary().forEach { out.println(withControlsShown(it)) }
            if (unanswered > 0) out.println(paint.doubtful("$unanswered requests without an answer"))
            out.println(board.spoken + if (damaged > 0) "; $damaged damaged frames were dropped" else "")
            record?.let { out.println("recorded in $it") }
            out.flush()
        }

        private fun summaryOf(damaged: Long) = jsonOf(
            "messages" to rates.messages, "unanswered" to unanswered, "protocol" to board.speaks, "corruptFrames" to damaged,
            "kinds" to rates.kinds().map { (kind, count, last) -> jsonOf("kind" to kind, "count" to count, "last" to last) },
        )
    }

    /** The percept [text], and its problem if any. [kinds] are the kinds in the board's description, or empty if it has none. */
    private class Shown(val text: String, kinds: List<PerceptKind>) {
        private val term = PerceptTerm.of(text)
        val whyUnbelieved: String? =
            whyUnreadable(text) ?: whyClaimed(term.indicator(), term.arguments().lastOrNull()?.substringBefore('[')?.trim())
        val deviation: String? = if (kinds.isEmpty()) null else PerceptKind.deviationOf(term, kinds).orElse(null)
        val words: String = PerceptKind.of(term, kinds).map { it.withUnits(term) }.orElse(text)
        val problem = whyUnbelieved?.let { "no agent believes $text: $it" }
            ?: deviation?.let { "$text is not as the board describes it: $it" }
    }

    private companion object {
        const val MAX_MS = 600_000
        const val MAX_EXPLAINED = 20
        const val MAX_PAUSE_MS = 200L
        const val TIME_WIDTH = 8
        const val RATE_WIDTH = 7
    }
}
