package argo.tools.board

import argo.mcap.McapReader
import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.ToolException
import argo.tools.command.making
import argo.tools.command.printable
import argo.tools.command.requireFile
import argo.tools.command.requireNew
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

    @Option(names = ["--link"], paramLabel = "PATH", description = ["a symbolic link to the pseudo-terminal, such as /tmp/ttyBOARD"])
    private var link: Path? = null

    override fun call(): Int {
        requireFile(file)
        if (McapReader.isMcap(file)) {
            throw ToolException("$file is a recording in the MCAP format, and none of a board; \"recording $file\" shows what it holds")
        }
        link?.let(::requireNew)
        val recording = Recording.read(file)
        val board = board(recording)
        if (!PseudoTerminals.available()) {
            throw ToolException(
                "there is no socat, which makes pseudo-terminals: \"sudo apt install socat\" or \"brew install socat\"; " +
                    "the port replay:$file needs none",
            )
        }
        val waits = !recording.isOfRequests && !inTurn
        return Interruption().use { PseudoTerminals.open().use { pair -> linked(pair) { serve(pair, it, board, waits) } } }
    }

    private fun board(recording: Recording): ReplayBoard {
        val board = try {
            ReplayBoard.of(recording).tellingCommandsTo { out.println("command: ${printable(it)}"); out.flush() }
        } catch (empty: IllegalArgumentException) {
            throw ToolException("$file: ${empty.message}")
        }
        return board.let { if (loop) it.repeated() else it }.let { if (inTurn) it.inTurn() else it }
    }

    /** Calls [serve] with the name of the port, which is a link while it runs if one was asked for. */
    private fun linked(pair: PseudoTerminals, serve: (String) -> Int): Int {
        val link = link ?: return serve(pair.computer().path)
        making(link) { Files.createSymbolicLink(it, pair.computer().toPath()) }
        return try {
            serve("$link")
        } finally {
            Files.deleteIfExists(link)
        }
    }

    private fun serve(pair: PseudoTerminals, port: String, board: ReplayBoard, waits: Boolean): Int {
        out.println(port)
        out.flush()
        err.println("$file is a board on this port until Ctrl-C: argo.port(\"$port\") in an agent, or the commands monitor and request")
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
