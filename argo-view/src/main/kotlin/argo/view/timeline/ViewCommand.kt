package argo.view.timeline

import argo.recording.replay.Recording
import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.ToolException
import argo.tools.command.ToolProvider
import argo.tools.command.requireFile
import argo.tools.command.requireWithin
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.net.BindException
import java.nio.file.Path
import java.util.concurrent.CountDownLatch

@Command(
    name = "view",
    description = [
        "Shows a recording of agents (FILE.mcap) as a timeline, in a browser on this computer. Ctrl-C ends it.",
    ],
)
internal class ViewCommand : ToolCommand() {
    @Parameters(index = "0", paramLabel = "FILE", description = ["a recording of agents, by their argo_record"])
    private lateinit var file: Path

    @Option(names = ["--port"], paramLabel = "PORT", defaultValue = "0", description = ["where the page is served; 0: any free port"])
    private var port = 0

    override fun call(): Int {
        spec.requireWithin("--port", port, 0..MAX_PORT)
        requireFile(file)
        val (timeline, problems) = read()
        problems.forEach { err.println("$file: $it") }
        val server = try {
            TimelineServer(timeline, file, problems, port)
        } catch (taken: BindException) {
            throw ToolException("port $port cannot be had: ${taken.message}; --port 0 takes a free one")
        }
        return server.use {
            out.println("$file is shown at ${server.address}")
            out.flush()
            awaitEnd()
            if (problems.isEmpty()) ExitStatus.DONE else ExitStatus.FAILED
        }
    }

    private fun read(): Pair<Timeline, List<String>> = try {
        Recording(file).use { recording -> Timeline.of(recording) to recording.problems }
    } catch (unreadable: IllegalArgumentException) {
        throw ToolException("$file: a message in it cannot be read: ${unreadable.message?.lineSequence()?.first()}")
    }

    /** Waits until the program is ended or the thread is interrupted. */
    private fun awaitEnd() = try {
        CountDownLatch(1).await()
    } catch (_: InterruptedException) {
        // the page is closed
    }

    private companion object {
        const val MAX_PORT = 65_535
    }
}

/** Adds `view` to the tools. */
class ViewCommandProvider : ToolProvider {
    override fun command(): Any = ViewCommand()
}
