package samples.typedfilters

import picocli.CommandLine.Command
import picocli.CommandLine.Option
import samples.project.SampleProject
import samples.project.SystemRun
import java.util.concurrent.Callable

/** `typed-filters`: filters written in Kotlin. */
@Command(
    name = "typed-filters",
    description = [
        "An agent looks at the world through filters that are written in Kotlin, and asks why it misses what it misses.",
        "The robot is the simulated one of the sample collision.",
    ],
)
internal class TypedFiltersCommand : Callable<Int> {
    @Option(names = ["-h", "--help"], usageHelp = true, description = ["shows this"])
    private var help = false

    override fun call(): Int = SystemRun(SampleProject("typed-filters")).toItsEnd()
}
