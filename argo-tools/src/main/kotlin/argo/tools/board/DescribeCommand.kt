package argo.tools.board

import argo.filters.matching.OWN_BELIEFS
import argo.filters.withControlsShown
import argo.recording.replay.Recording
import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.counted
import argo.tools.command.making
import argo.tools.command.requireFile
import argo.tools.command.requireNew
import argo.tools.command.requireWithin
import javino.PerceptKind
import javino.PerceptsRequest
import javino.PortInterruptedException
import javino.link.Link
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption

@Command(
    name = "describe",
    description = [
        "Writes the kinds of a board's percepts into a file, one a line, for checks of a project: as the board describes them, " +
            "or else as they are observed for some seconds, or in the recording of an agent.",
        "Ctrl-C ends it, and what was observed until then is written. Opening a port resets most boards.",
    ],
)
internal class DescribeCommand : ToolCommand() {
    @Mixin
    private lateinit var line: LineOptions

    @Parameters(index = "0", paramLabel = "PORT", description = ["ttyACM0, COM8, /dev/pts/3, replay:FILE.rec, FILE.mcap"])
    private lateinit var port: String

    @Parameters(
        index = "1", arity = "0..1", paramLabel = "FILE", defaultValue = "percepts",
        description = ["a new file; checks read those called percepts or NAME.percepts (\${DEFAULT-VALUE})"],
    )
    private lateinit var file: Path

    @Option(
        names = ["--seconds"], paramLabel = "S", defaultValue = "10",
        description = ["how long a board that describes nothing is observed (\${DEFAULT-VALUE})"],
    )
    private var seconds = 0

    @Option(names = ["--listen"], description = ["for a board that sends percepts unasked"])
    private var listens = false

    override fun call(): Int {
        spec.requireWithin("--seconds", seconds, 1..MAX_SECONDS)
        requireNew(file) // fails before the port is opened, since opening resets the board
        if (port.endsWith(RECORDING)) return describeRecorded(Path.of(port))
        return try {
            Interruption().use { line.open(port).use(::describe) }
        } catch (_: PortInterruptedException) {
            err.println("interrupted before the board was observed; nothing was written to $file")
            ExitStatus.FAILED
        }
    }

    private fun describe(link: Link): Int {
        val first = message(link)
        val described = DescribedKinds.of(link, line.timeoutMs)
        val trouble = listOfNotNull(described.trouble?.let { "kinds of percepts: $it" })
        if (described.kinds.isEmpty()) return observe(link, first, trouble)
        val (own, kinds) = described.kinds.partition { it.indicator in OWN_BELIEFS }
        write("as it describes them", kinds.map(PerceptKind::toString), trouble + listOfNotNull(ownLeftOut(own.map { it.indicator })))
        return ExitStatus.DONE
    }

    private fun observe(link: Link, first: String, trouble: List<String>): Int {
        val observation = Observation(seconds, listens)
        observation.run(first) {
            if (!listens) link.watch(INTERVAL_MS)
            message(link)
        }
        val kinds = observation.kinds().map { "$it # observed" }
        write("as observed for ${counted(seconds, "second")}", kinds, trouble + observation.notes())
        return if (observation.isLost) ExitStatus.FAILED else ExitStatus.DONE
    }

    private fun describeRecorded(recording: Path): Int {
        requireFile(recording)
        val observation = Observation(seconds, listens)
        val problems = Recording(recording).use { recorded ->
            val cycles = recorded.agents.keys.asSequence().flatMap { recorded.cycles(it) }
            cycles.flatMap { it.input.snapshots }.flatMap { it.texts }.forEach(observation::add)
            recorded.problems
        }
        write("as agents perceived them", observation.kinds().map { "$it # observed" }, problems + observation.notes())
        return if (problems.isEmpty()) ExitStatus.DONE else ExitStatus.FAILED
    }

    private fun message(link: Link) =
        (if (listens) link.listen(line.timeoutMs) else link.request(PerceptsRequest.ALL, line.timeoutMs)).text()

    /** Writes the [kinds] to the file. Writes and prints their [origin] and the reasons why some are [missing]. */
    private fun write(origin: String, kinds: List<String>, missing: List<String>) {
        val notes = missing.map(::withControlsShown)
        val head = listOf("# Percepts of the board at $port, $origin") + notes.map { "# $it" }
        Thread.interrupted() // Ctrl-C must not prevent the file
        making(file) { Files.write(it, head + kinds, StandardOpenOption.CREATE_NEW) }
        out.println("$file has ${counted(kinds.size, "kind")} of percepts, $origin")
        notes.forEach { out.println(paint.doubtful(it)) }
    }

    private val PerceptKind.indicator get() = "${functor()}/${arguments().size}"

    private companion object {
        const val MAX_SECONDS = 3600
        const val RECORDING = ".mcap"
        const val INTERVAL_MS = 100
    }
}
