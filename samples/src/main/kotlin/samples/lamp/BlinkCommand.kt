package samples.lamp

import argo.tools.command.ToolCommand
import jason.asSyntax.ASSyntax.createLiteral
import jason.asSyntax.ASSyntax.createString
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import samples.project.MasRun
import samples.project.SampleProject

@Command(
    name = "blink",
    description = ["The smallest agent: it has the LED of a board blink, once a second."],
    sortOptions = false,
)
internal class BlinkCommand : ToolCommand() {
    @Option(
        names = ["--port"], paramLabel = "device", defaultValue = "sim:blink",
        description = ["the board's port, such as ttyACM0 or COM5 (default: \${DEFAULT-VALUE}, which is simulated)"],
    )
    private lateinit var port: String

    @Option(names = ["--seconds"], paramLabel = "n", defaultValue = "10", description = ["how long it runs (default: \${DEFAULT-VALUE})"])
    private var seconds = 0

    override fun call(): Int {
        if (seconds < 1) misuse("--seconds is at least 1, not $seconds")
        val project = SampleProject("blink").apply { believe("blink", createLiteral("board", createString(port))) }
        return MasRun(project).forAtMost(seconds)
    }
}
