package argo.tools.samples

import argo.tools.command.ExitStatus
import argo.tools.command.Installation
import argo.tools.command.ToolException
import argo.tools.command.ownJar
import argo.tools.command.runJava
import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Spec
import picocli.CommandLine.Unmatched
import java.nio.file.Path
import java.util.concurrent.Callable

/** Runs the program in [module], `samples` or `experiment`, with [words] and all arguments unchanged. */
@Command
internal abstract class SampleProgramCommand(private val module: String, private vararg val words: String) : Callable<Int> {
    @Spec
    private lateinit var spec: CommandSpec

    @Unmatched
    private var arguments: MutableList<String> = ArrayList()

    override fun call(): Int {
        val classPath = try {
            Installation(ownJar() ?: Path.of("")).classPathOf(module)
        } catch (missing: ToolException) {
            return if (arguments.any { it in HELP }) help(missing) else throw missing
        }
        return runJava(listOf("-Dargo.command=${spec.root().name()}", "-cp", classPath, "$module.MainKt") + words + arguments)
    }

    /** Prints this command's own help. The options of the samples are [missing]. */
    private fun help(missing: ToolException): Int {
        spec.commandLine().usage(spec.commandLine().out)
        spec.commandLine().out.println("\nIts options cannot be listed: ${missing.message}")
        return ExitStatus.DONE
    }

    private companion object {
        val HELP = setOf("-h", "--help")
    }
}

@Command(
    name = "demo",
    description = ["A robot drives at a wall and its agent stops it; no hardware needed. --help lists its options."],
)
internal class DemoCommand : SampleProgramCommand("samples", "demo")

@Command(name = "experiment", description = ["Makes all runs of the published experiment and a report. --help lists its options."])
internal class ExperimentCommand : SampleProgramCommand("experiment")

@Command(name = "sample", description = ["Runs the sample of the name that follows. --help lists the samples."])
internal class SampleCommand : SampleProgramCommand("samples")
