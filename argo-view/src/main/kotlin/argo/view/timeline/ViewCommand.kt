package argo.view.timeline

import argo.recording.replay.ClockDifference
import argo.recording.replay.JointRecordings
import argo.recording.replay.Recording
import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.ToolException
import argo.tools.command.ToolProvider
import argo.tools.command.requireFile
import argo.tools.command.requireWithin
import argo.tools.command.withAll
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
        "Recordings of several programs, as of a fleet's computers, are one timeline: their messages show how their clocks differ.",
    ],
)
internal class ViewCommand : ToolCommand() {
    @Parameters(arity = "1..*", paramLabel = "FILE", description = ["recordings of agents, by their argo_record"])
    private lateinit var files: List<Path>

    @Option(names = ["--port"], paramLabel = "PORT", defaultValue = "0", description = ["where the page is served; 0: any free port"])
    private var port = 0

    override fun call(): Int {
        spec.requireWithin("--port", port, 0..MAX_PORT)
        files.forEach(::requireFile)
        val (timeline, problems) = withAll(files, { Recording(it) }, work = ::read)
        problems.forEach(err::println)
        val server = try {
            TimelineServer(timeline, files, problems, port)
        } catch (taken: BindException) {
            throw ToolException("port $port cannot be had: ${taken.message}; --port 0 takes a free one")
        }
        return server.use {
            out.println("${files.joinToString()} ${if (files.size == 1) "is" else "are"} shown at ${server.address}")
            out.flush()
            awaitEnd()
            if (problems.isEmpty()) ExitStatus.DONE else ExitStatus.FAILED
        }
    }

    private fun read(recordings: List<Recording>): Pair<Timeline, List<String>> = try {
        val ahead = if (recordings.size == 1) listOf(ClockDifference.NONE) else JointRecordings(recordings).differencesOfClocks
        val clocks = files.zip(ahead).drop(1).map { (file, it) ->
            if (it == null) "$file: no message connects it with ${files.first()}, so its times are those of its own clock"
            else "$file: compared with ${files.first()}, its clock is $it"
        }
        clocks.forEach(out::println)
        val problems = files.zip(recordings).flatMap { (file, recording) -> recording.problems.map { "$file: $it" } }
        Timeline.ofAll(recordings, ahead.map { it?.ns ?: 0 }) to problems
    } catch (unreadable: IllegalArgumentException) {
        throw ToolException("${files.joinToString()}: a message cannot be read: ${unreadable.message?.lineSequence()?.first()}")
    }

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
