package argo.ros.joining

import argo.links.BoardLink
import argo.links.JavinoLink
import argo.ros.bridge.LimitedWarnings
import argo.tools.board.LineOptions
import argo.tools.command.ToolCommand
import argo.tools.command.ToolProvider
import argo.tools.command.requireWithin
import javino.NoSuchPortException
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.util.concurrent.CountDownLatch

@Command(
    name = "ros-join",
    description = [
        "Has boards take part in the ROS graph behind a rosbridge_server: percepts are topics, commands are services, topics and actions.",
        "A board or a bridge that goes is taken in again when it is back. Ctrl-C ends it.",
        "Opening a port resets most boards.",
    ],
)
internal class RosJoinCommand : ToolCommand() {
    @Mixin
    private lateinit var line: LineOptions

    @Parameters(
        paramLabel = "BOARD", arity = "1..*",
        description = ["a port, as ttyACM0, or a name for the graph and a port, as uno=ttyACM0"],
    )
    private var boards: List<String> = emptyList()

    @Option(
        names = ["--at"], paramLabel = "ADDRESS", defaultValue = "localhost:9090",
        description = ["where the bridge listens, HOST:PORT (\${DEFAULT-VALUE})"],
    )
    private lateinit var at: String

    @Option(
        names = ["--interval"], paramLabel = "MS", defaultValue = "50",
        description = ["from one request to the next, milliseconds; 0: as fast as the line allows (\${DEFAULT-VALUE})"],
    )
    private var intervalMs = 0

    @Option(names = ["--listen"], description = ["for boards that send their percepts unasked"])
    private var listens = false

    override fun call(): Int {
        spec.requireWithin("--interval", intervalMs, 0..MAX_MS, "ms")
        val ports = boards.map(::named)
        ports.groupBy { it.first }.values.find { it.size > 1 }?.let { misuse("two boards are called ${it[0].first}; write NAME=PORT") }
        val bridge = try {
            BridgeAddress.of(at)
        } catch (refused: NoSuchPortException) {
            misuse("--at: ${refused.message}")
        }
        val joined = ports.map { (name, port) -> join(name, port, bridge) }
        try {
            CountDownLatch(1).await()
        } catch (_: InterruptedException) {
            joined.forEach { it.close() }
        }
        return 0
    }

    /** Adds the board [name] to the graph. Closing the result removes the board. */
    private fun join(name: String, port: String, bridge: BridgeAddress): AutoCloseable {
        val warn = LimitedWarnings { tell("/$name: $it") }
        val topics = Topics(warn)
        val board = JoinedBoard(name, port, topics, intervalMs, line.timeoutMs, listens, { open(port) }, ::tell, warn)
        val membership = Membership(board, topics, bridge, ::tell, warn)
        board.start()
        membership.start()
        return AutoCloseable {
            membership.close()
            board.close()
        }
    }

    private fun named(board: String): Pair<String, String> {
        val (name, port) = NAMED.matchEntire(board)?.destructured ?: return graphName(board) to board
        if (graphName(name) != name) misuse("'$name' is no name for the graph; one has letters, digits and '_'")
        return name to port
    }

    private fun open(port: String): BoardLink = line.openElsewhere(port) ?: JavinoLink(line.open(port))

    private fun tell(message: String) = err.run {
        println(message)
        flush()
    }

    private companion object {
        val NAMED = Regex("([A-Za-z0-9_]+)=(.+)")
        const val MAX_MS = 600_000
    }
}

class RosJoinProvider : ToolProvider {
    override fun command(): Any = RosJoinCommand()
}
