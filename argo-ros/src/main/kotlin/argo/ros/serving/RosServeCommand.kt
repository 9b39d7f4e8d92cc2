package argo.ros.serving

import argo.links.BoardLink
import argo.links.BoardLinkProvider
import argo.links.JavinoLink
import argo.tools.board.LineOptions
import argo.tools.command.ToolProvider
import argo.tools.command.refuse
import argo.tools.command.requireWithin
import javino.LineClock
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.Callable
import java.util.concurrent.CountDownLatch

/** `ros-serve`: boards for ROS clients. */
@Command(
    name = "ros-serve",
    description = [
        "Offers boards to clients of the rosbridge protocol, as roslibpy: percepts are topics, commands are services and actions.",
        "Boards that go are opened again when they are back. Ctrl-C ends it.",
        "Opening a port resets most boards.",
    ],
)
internal class RosServeCommand : Callable<Int> {
    @Spec
    private lateinit var spec: CommandSpec

    @Mixin
    private lateinit var line: LineOptions

    @Parameters(
        paramLabel = "BOARD", arity = "1..*",
        description = ["a port, as ttyACM0, or a name for the graph and a port, as uno=ttyACM0"],
    )
    private var boards: List<String> = emptyList()

    @Option(
        names = ["--address"], paramLabel = "ADDRESS", defaultValue = "9090",
        description = ["PORT or HOST:PORT; without a host, clients of this computer alone (\${DEFAULT-VALUE})"],
    )
    private lateinit var address: String

    @Option(names = ["--token-file"], paramLabel = "FILE", description = ["a file whose first line clients must show as a token"])
    private var tokenFile: Path? = null

    @Option(
        names = ["--interval"], paramLabel = "MS", defaultValue = "50",
        description = ["from one request to the next, milliseconds; 0: as fast as the line allows (\${DEFAULT-VALUE})"],
    )
    private var intervalMs = 0

    @Option(names = ["--listen"], description = ["for boards that send their percepts unasked"])
    private var listens = false

    @Option(names = ["-h", "--help"], usageHelp = true, description = ["shows this"])
    private var help = false

    override fun call(): Int {
        spec.requireWithin("--interval", intervalMs, 0..MAX_MS, "ms")
        val ports = boards.map(::named)
        ports.groupBy { it.first }.values.find { it.size > 1 }?.let { spec.refuse("two boards are called ${it[0].first}; write NAME=PORT") }
        val access = try {
            Access.of(address, tokenFile?.let { Files.readAllLines(it).firstOrNull().orEmpty().trim() })
        } catch (refused: RefusedServer) {
            spec.refuse("--address: ${refused.message}")
        }
        val graph = Graph(onceEach(::tell))
        val server = try {
            RosServer(access, graph, ::tell)
        } catch (refused: RefusedServer) {
            spec.refuse("--address: ${refused.message}")
        }
        val served = ports.map { (name, port) ->
            ServedBoard(name, port, graph.topics, intervalMs, line.timeoutMs, listens, { open(port) }, ::tell)
        }
        serve(server, access, graph, served)
        return 0
    }

    /** Serves until the program is ended or the thread is interrupted. */
    private fun serve(server: RosServer, access: Access, graph: Graph, served: List<ServedBoard>) {
        val end = Thread {
            served.forEach { it.close() }
            server.close()
        }
        Runtime.getRuntime().addShutdownHook(end)
        served.forEach {
            graph.add(it)
            it.start()
        }
        spec.commandLine().out.run {
            println("ros://${access.address.hostString}:${server.port} offers ${graph.nodes.sorted().joinToString()}")
            flush()
        }
        try {
            CountDownLatch(1).await()
        } catch (_: InterruptedException) {
            Runtime.getRuntime().removeShutdownHook(end)
            end.run()
        }
    }

    private fun named(board: String): Pair<String, String> {
        val (name, port) = NAMED.matchEntire(board)?.destructured ?: return graphName(board) to board
        if (graphName(name) != name) spec.refuse("'$name' is no name for the graph; one has letters, digits and '_'")
        return name to port
    }

    private fun open(port: String): BoardLink =
        BoardLinkProvider.of(port)?.open(port, true, LineClock.system()) ?: JavinoLink(line.open(port))

    private fun tell(message: String) = spec.commandLine().err.run {
        println(message)
        flush()
    }

    private companion object {
        val NAMED = Regex("([A-Za-z0-9_]+)=(.+)")
        const val MAX_MS = 600_000
    }
}

/** Adds `ros-serve` to the tools. */
class RosServeProvider : ToolProvider {
    override fun command(): Any = RosServeCommand()
}
