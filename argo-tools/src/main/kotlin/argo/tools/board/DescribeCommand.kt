package argo.tools.board

import argo.filters.matching.perceptsOf
import argo.filters.matching.whyUnreadable
import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.counted
import argo.tools.command.making
import argo.tools.command.requireNew
import argo.tools.command.requireWithin
import javino.PerceptKind
import javino.PerceptsRequest
import javino.PortTimeoutException
import javino.link.Link
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.util.concurrent.TimeUnit

@Command(
    name = "describe",
    description = [
        "Writes the kinds of a board's percepts into a file, one a line, for checks of a project: as the board describes them, " +
            "or else as they are observed for some seconds.",
        "Opening a port resets most boards.",
    ],
)
internal class DescribeCommand : ToolCommand() {
    @Mixin
    private lateinit var line: LineOptions

    @Parameters(index = "0", paramLabel = "PORT", description = ["ttyACM0, COM8, /dev/pts/3, replay:FILE"])
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
        requireNew(file) // before the port is opened, which resets the board
        val (origin, lines) = line.open(port).use(::described)
        making(file) { Files.write(it, listOf("# Percepts of the board at $port, $origin") + lines, StandardOpenOption.CREATE_NEW) }
        out.println("$file has ${counted(lines.size, "kind")} of percepts, $origin")
        return ExitStatus.DONE
    }

    /** Returns where the kinds of percepts come from, and a line for each. */
    private fun described(link: Link): Pair<String, List<String>> {
        val first = message(link)
        val kinds = link.perceptKinds(line.timeoutMs)
        return if (kinds.isEmpty()) observed(link, first) else "as it describes them" to kinds.map(PerceptKind::toString)
    }

    private fun message(link: Link) =
        (if (listens) link.listen(line.timeoutMs) else link.request(PerceptsRequest.ALL, line.timeoutMs)).text()

    private fun observed(link: Link, first: String): Pair<String, List<String>> {
        val observed = ObservedKinds()
        val end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds.toLong())
        var text: String? = first
        while (System.nanoTime() - end < 0) {
            text?.let(::perceptsOf)?.filter { whyUnreadable(it) == null }?.forEach(observed::add)
            if (!listens) link.watch(INTERVAL_MS)
            text = try {
                message(link)
            } catch (_: PortTimeoutException) {
                null // the next message may come
            }
        }
        val left = if (observed.others == 0L) "" else "; ${counted(observed.others, "percept")} of further kinds are left out"
        return "as observed for ${counted(seconds, "second")}$left" to observed.kinds().map { "$it # observed" }
    }

    private companion object {
        const val MAX_SECONDS = 3600
        const val INTERVAL_MS = 100
    }
}
