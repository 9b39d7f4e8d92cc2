package samples.lamp

import picocli.CommandLine.Command
import picocli.CommandLine.Option
import samples.project.SampleProject
import samples.project.SystemRun
import java.util.concurrent.Callable

/** `two-boards`: one agent, two ports. */
@Command(
    name = "two-boards",
    description = ["One agent that works with two boards in turn, by changing its port at run time. The boards are simulated."],
)
internal class TwoBoardsCommand : Callable<Int> {
    @Option(names = ["-h", "--help"], usageHelp = true, description = ["shows this"])
    private var help = false

    override fun call(): Int = SystemRun(SampleProject("two-boards")).toItsEnd()
}
