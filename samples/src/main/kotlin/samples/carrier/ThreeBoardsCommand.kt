package samples.carrier

import picocli.CommandLine.Command
import picocli.CommandLine.Option
import samples.project.SampleProject
import samples.project.SystemRun
import java.util.concurrent.Callable

/** `three-boards`: one robot of wheels, sensors and an arm. */
@Command(
    name = "three-boards",
    description = ["A robot of three boards, wheels, sensors and an arm, fetches a can. The boards are simulated."],
)
internal class ThreeBoardsCommand : Callable<Int> {
    @Option(names = ["-h", "--help"], usageHelp = true, description = ["shows this"])
    private var help = false

    override fun call(): Int = SystemRun(SampleProject("three-boards")).toItsEnd()
}
