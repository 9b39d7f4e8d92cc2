package argo.view.timeline

import argo.recording.replay.Recording
import argo.tools.command.ToolProvider
import argo.tools.command.requireWithin
import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import java.io.IOException
import java.net.BindException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.Callable
import java.util.concurrent.CountDownLatch

/** `view`: shows a recording of agents in a browser. */
@Command(
    name = "view",
    description = [
        "Shows a recording of agents (FILE.mcap) as a timeline, in a browser on this computer. Ctrl-C ends it.",
    ],
)
internal class ViewCommand : Callable<Int> {
    @Spec
    private lateinit var spec: CommandSpec

    @Parameters(index = "0", paramLabel = "FILE", description = ["a recording of agents, by their argo_record"])
    private lateinit var file: Path

    @Option(names = ["--port"], paramLabel = "PORT", defaultValue = "0", description = ["where the page is served; 0: any free port"])
    private var port = 0

    @Option(names = ["-h", "--help"], usageHelp = true, description = ["shows this"])
    private var help = false

    override fun call(): Int {
        spec.requireWithin("--port", port, 0..MAX_PORT)
        if (!Files.isRegularFile(file)) {
            tell("there is no file $file")
            return FAILED
        }
        val (timeline, problems) = read() ?: return FAILED
        problems.forEach { tell("$file: $it") }
        val server = try {
            TimelineServer(timeline, file, problems, port)
        } catch (taken: BindException) {
            tell("port $port cannot be had: ${taken.message}; --port 0 takes a free one")
            return FAILED
        }
        return server.use {
            spec.commandLine().out.run {
                println("$file is shown at ${server.address}")
                flush()
            }
            awaitEnd()
            if (problems.isEmpty()) 0 else FAILED
        }
    }

    private fun read(): Pair<Timeline, List<String>>? = try {
        Recording(file).use { recording -> Timeline.of(recording).let { it to recording.problems } }
    } catch (unreadable: IOException) {
        null.also { tell(unreadable.message ?: "$unreadable") }
    } catch (unreadable: IllegalArgumentException) {
        null.also { tell("$file: a message in it cannot be read: ${unreadable.message?.lineSequence()?.first()}") }
    }

    /** Waits until the program is ended or the thread is interrupted. */
    private fun awaitEnd() = try {
        CountDownLatch(1).await()
    } catch (_: InterruptedException) {
        // the page is closed
    }

    private fun tell(message: String) = spec.commandLine().err.run {
        println(message)
        flush()
    }

    private companion object {
        const val FAILED = 1
        const val MAX_PORT = 65_535
    }
}

/** Adds `view` to the tools. */
class ViewCommandProvider : ToolProvider {
    override fun command(): Any = ViewCommand()
}
