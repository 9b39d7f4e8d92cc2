package argo.tools.board

import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.ToolException
import argo.tools.command.printable
import argo.tools.command.requireFile
import javino.LineSettings
import javino.PortException
import javino.PortInterruptedException
import javino.Transports
import javino.serial.SerialPorts
import javino.sim.PseudoTerminals
import javino.sim.Recording
import javino.sim.ReplayBoard
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** `replay`: serves a recording as a board. */
@Command(
    name = "replay",
    description = [
        "Serves a recording as a board on a pseudo-terminal until Ctrl-C; prints its name and the received commands.",
        "An agent, and these tools, can also open the port replay:FILE, without this command.",
    ],
)
internal class ReplayCommand : ToolCommand() {
    @Parameters(index = "0", paramLabel = "FILE", description = ["a recording made by monitor --record"])
    private lateinit var file: Path

    @Option(names = ["--loop"], description = ["restarts at the end of the recording"])
    private var loop = false

    @Option(names = ["--in-turn"], description = ["answers the first request with the first answer and so on, ignoring times"])
    private var inTurn = false

    override fun call(): Int {
        requireFile(file)
        val recording = Recording.read(file)
        val board = board(recording)
        if (!PseudoTerminals.available()) {
            throw ToolException(
                "there is no socat, which makes pseudo-terminals: \"sudo apt install socat\" or \"brew install socat\"; " +
                    "the port replay:$file needs none",
            )
        }
        return Interruption().use { PseudoTerminals.open().use { serve(it, board, waits = !recording.isOfRequests && !inTurn) } }
    }

    private fun board(recording: Recording): ReplayBoard {
        val board = try {
            ReplayBoard.of(recording).tellingCommandsTo { out.println("command: ${printable(it)}"); out.flush() }
        } catch (empty: IllegalArgumentException) {
            throw ToolException("$file: ${empty.message}")
        }
        return board.let { if (loop) it.repeated() else it }.let { if (inTurn) it.inTurn() else it }
    }

    private fun serve(pair: PseudoTerminals, board: ReplayBoard, waits: Boolean): Int {
        out.println(pair.computer().path)
        out.flush()
        try {
            if (waits) awaitListener(pair)
            Transports.open(pair.board().path, LineSettings.defaults()).use(board::run)
        } catch (_: PortInterruptedException) {
            Thread.interrupted() // the terminals are still to be removed
        } catch (_: InterruptedException) {
            // as above
        } catch (gone: PortException) {
            if (!Thread.interrupted()) throw ToolException("the pseudo-terminal is lost: ${gone.message}")
        }
        return ExitStatus.DONE
    }

    /** A board that sends unasked starts when the far end is open, or at once where the system does not reveal that. */
    private fun awaitListener(pair: PseudoTerminals) {
        if (!Files.isDirectory(Path.of("/proc/self/fd"))) return
        while (SerialPorts.holders(pair.computer().path).none { "socat" !in it }) TimeUnit.MILLISECONDS.sleep(POLL_MS)
    }

    private companion object {
        const val POLL_MS = 100L
    }
}
