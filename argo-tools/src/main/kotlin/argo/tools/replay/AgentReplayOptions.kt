package argo.tools.replay

import picocli.CommandLine.Option
import java.nio.file.Path

internal class AgentReplayOptions {
    @Option(
        names = ["--check"],
        description = [
            "carries the project's own actions out again, and names all that gives another result; then the exit status is 1",
        ],
    )
    var isCheck = false
        private set

    @Option(
        names = ["--from"],
        paramLabel = "S|cN",
        converter = [Moment.Converter::class],
        description = ["prints the cycles from this second, or cycle, on"],
    )
    var from: Moment? = null
        private set

    @Option(
        names = ["--until"],
        paramLabel = "S|cN",
        converter = [Moment.Converter::class],
        description = ["replays the cycles before this second, or this cycle, and prints the beliefs there"],
    )
    var until: Moment? = null
        private set

    @Option(names = ["--of"], paramLabel = "AGENT", description = ["prints the beliefs of only this agent; may be given several times"])
    var of: Set<String> = emptySet()
        private set

    @Option(
        names = ["--agent"],
        paramLabel = "[AGENT=]FILE",
        description = ["runs the agent with this program, and shows the first command that differs; may be given for several agents"],
    )
    var programs: List<String> = emptyList()
        private set

    @Option(
        names = ["--filter"],
        paramLabel = "FILE",
        description = ["runs the agent with this filter (.xml, .json), and shows the first command that differs"],
    )
    var filter: Path? = null
        private set

    @Option(
        names = ["--debug"],
        paramLabel = "PORT",
        description = [
            "pauses before the first cycle and at breakpoints, lets debuggers of editors reach the agents at this port; 0: any port",
        ],
    )
    var debugPort: Int? = null
        private set

    val isWhatIf: Boolean get() = programs.isNotEmpty() || filter != null

    @Option(
        names = ["--within"],
        paramLabel = "MS",
        description = ["with --agent or --filter: how much earlier or later the same command may be; 100 unless given"],
    )
    var within: Long? = null
        private set
}
