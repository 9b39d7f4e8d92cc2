package samples.delegation

import picocli.CommandLine.Command
import picocli.CommandLine.Option
import samples.project.SampleProject
import samples.project.SystemRun
import java.util.concurrent.Callable

/** `delegation`: three agents, one of which has a body. */
@Command(
    name = "delegation",
    description = [
        "An ARGO agent that only senses and acts, and two common Jason agents that reason on what it tells them.",
        "The robot is the simulated one of the sample collision.",
    ],
)
internal class DelegationCommand : Callable<Int> {
    @Option(names = ["-h", "--help"], usageHelp = true, description = ["shows this"])
    private var help = false

    override fun call(): Int = SystemRun(SampleProject("delegation")).toItsEnd()
}
