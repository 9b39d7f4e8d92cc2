package argo.tools.board

import argo.filters.withControlsShown
import argo.mcap.McapReader
import argo.tools.command.ExitStatus
import argo.tools.command.ToolException
import argo.tools.command.making
import argo.tools.command.requireFile
import argo.tools.command.requireNew
import argo.tools.filter.filterIn
import argo.tools.replay.AgentReplay
import argo.tools.replay.AgentReplayOptions
import argo.tools.replay.AgentWhatIf
import argo.tools.replay.JasonCommand
import javino.LineSettings
import javino.PortException
import javino.PortInterruptedException
import javino.Transports
import javino.serial.SerialPorts
import javino.sim.LineRecording
import javino.sim.PseudoTerminals
import javino.sim.ReplayBoard
import picocli.CommandLine.ArgGroup
import picocli.CommandLine.Command
import picocli.CommandLine.Parameters
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.TimeUnit
import kotlin.io.path.extension

@Command(
    name = "replay",
    description = [
        "Runs the agents of a recording (FILE.mcap) again, or serves a recording of a board (FILE.rec) as a board.",
        "As a board: on a pseudo-terminal until Ctrl-C; prints its name and the received commands.",
        "An agent, and these tools, can also open the port replay:FILE, without this command.",
        "Of agents: runs them on their recorded input, and reports whether they do the same.",
    ],
)
internal class ReplayCommand : JasonCommand() {
    @Parameters(index = "0", paramLabel = "FILE", description = ["a recording by monitor --record or an agent's argo_record"])
    private lateinit var file: Path

    @ArgGroup(validate = false, heading = "%nof a recording of a board:%n")
    private var asBoard: BoardReplayOptions? = null

    @ArgGroup(validate = false, heading = "%nof a recording of agents:%n")
    private var ofAgents: AgentReplayOptions? = null

    private val board get() = asBoard ?: BoardReplayOptions()

    override fun call(): Int {
        requireFile(file)
        if (McapReader.isMcap(file)) {
            if (asBoard != null) misuse("--loop, --in-turn and --link are for a recording of a board, and $file is one of agents")
            return replayAgents(ofAgents ?: AgentReplayOptions())
        }
        if (ofAgents != null || classPath != null || json) {
            misuse(
                "--check, --from, --until, --of, --agent, --filter, --within, --debug, --class-path and --json are for a recording of " +
                    "agents, and $file is none",
            )
        }
        return serveBoard()
    }

    private fun replayAgents(options: AgentReplayOptions): Int {
        if (options.within != null && !options.isWhatIf) misuse("--within is for --agent and --filter")
        options.within?.let { if (it < 0) misuse("--within is 0 ms at least, not $it") }
        tellUnusedOptions()
        if (!runsHere) return runElsewhere("$file")
        if (options.isWhatIf) return runOthers(options)
        val report = AgentReplay(file, options).run { agent, changed ->
            changed.forEach { err.println("$it has changed since; breakpoints and places are those of the recorded program") }
            err.println("agent $agent is paused before its first cycle; attach a debugger, set breakpoints, and have it continue")
        }
        if (json) out.println(report.json()) else report.lines("$file", options.isCheck).forEach { out.println(withControlsShown(it)) }
        report.problems.forEach { err.println("$file: ${withControlsShown(it)}") }
        val isGood = report.problems.isEmpty() && report.isWhole && (if (options.isCheck) report.isDeterministic else report.isIdentical)
        return if (isGood) ExitStatus.DONE else ExitStatus.FAILED
    }

    private fun runOthers(options: AgentReplayOptions): Int {
        if (options.isCheck || options.from != null || options.until != null || options.of.isNotEmpty() || options.debugPort != null) {
            misuse("--check, --from, --until, --of and --debug are for the recorded program, and --agent and --filter for others")
        }
        val within = Duration.ofMillis(options.within ?: WITHIN_MS)
        val report = AgentWhatIf(file, options.programs, options.filter?.let(::filterIn), within).run()
        if (json) out.println(report.json()) else report.lines().forEach { out.println(withControlsShown(it)) }
        report.problems.forEach { err.println("$file: ${withControlsShown(it)}") }
        return if (report.problems.isEmpty() && report.isIdentical) ExitStatus.DONE else ExitStatus.FAILED
    }

    private fun serveBoard(): Int {
        if (file.extension == "mcap") throw ToolException("$file is no recording of agents: it does not begin as an MCAP file")
        board.link?.let(::requireNew)
        val recording = LineRecording.read(file)
        val replayed = board(recording)
        if (!PseudoTerminals.available()) {
            throw ToolException(
                "there is no socat, which makes pseudo-terminals: \"sudo apt install socat\" or \"brew install socat\"; " +
                    "the port replay:$file needs none",
            )
        }
        val waits = !recording.isOfRequests && !board.inTurn
        return Interruption().use { interruption ->
            PseudoTerminals.open().use { pair -> linked(pair) { serve(pair, it, replayed, waits, interruption) } }
        }
    }

    private fun board(recording: LineRecording): ReplayBoard {
        val replayed = try {
            ReplayBoard.of(recording).tellingCommandsTo { out.println("command: ${withControlsShown(it)}"); out.flush() }
        } catch (empty: IllegalArgumentException) {
            throw ToolException("$file: ${empty.message}")
        }
        return replayed.let { if (board.loop) it.repeated() else it }.let { if (board.inTurn) it.inTurn() else it }
    }

    /** Calls [serve] with the port's name. With --link, the name is that of a symbolic link, which exists while [serve] runs. */
    private fun linked(pair: PseudoTerminals, serve: (String) -> Int): Int {
        val link = board.link ?: return serve(pair.computer().path)
        making(link) { Files.createSymbolicLink(it, pair.computer().toPath()) }
        return try {
            serve("$link")
        } finally {
            Files.deleteIfExists(link)
        }
    }

    private fun serve(pair: PseudoTerminals, port: String, board: ReplayBoard, waits: Boolean, interruption: Interruption): Int {
        out.println(port)
        out.flush()
        err.println("$file is played on port $port until Ctrl-C; open it with argo.port(\"$port\") in an agent, or by monitor or request")
        try {
            if (waits) awaitListener(pair)
            Transports.open(pair.board().path, LineSettings.defaults()).use(board::run)
        } catch (_: PortInterruptedException) {
            Thread.interrupted() // Ctrl-C must not prevent the removal of the terminals
        } catch (_: InterruptedException) {
            // Ctrl-C ended the wait for a listener
        } catch (gone: PortException) {
            if (!interruption.isEnding()) throw ToolException("the pseudo-terminal is lost: ${gone.message}")
        }
        return ExitStatus.DONE
    }

    /**
     * Waits until a program opens the port. Boards that send unasked need this. Returns at once if the operating system does not show open
     * files.
     */
    private fun awaitListener(pair: PseudoTerminals) {
        if (!Files.isDirectory(Path.of("/proc/self/fd"))) return
        while (SerialPorts.holders(pair.computer().path).none { "socat" !in it }) TimeUnit.MILLISECONDS.sleep(POLL_MS)
        TimeUnit.MILLISECONDS.sleep(START_MS)
    }

    private companion object {
        const val POLL_MS = 100L

        /**
         * The delay between the opening of the port and the start of the board. A program's serial driver discards all bytes during this
         * time.
         */
        const val START_MS = 500L

        const val WITHIN_MS = 100L
    }
}
