package argo.tools

import argo.tools.board.DescribeCommand
import argo.tools.board.MonitorCommand
import argo.tools.board.PortsCommand
import argo.tools.board.ReplayCommand
import argo.tools.board.RequestCommand
import argo.tools.board.SendCommand
import argo.tools.check.CheckCommand
import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.refuseWithout
import argo.tools.doctor.DoctorCommand
import argo.tools.exploring.ExploreCommand
import argo.tools.filter.FilterCommand
import argo.tools.project.NewCommand
import argo.tools.recording.RecordingCommand
import argo.tools.reloading.ReloadCommand
import argo.tools.samples.DemoCommand
import argo.tools.samples.ExperimentCommand
import argo.tools.samples.SampleCommand
import argo.tools.why.WhyCommand
import picocli.CommandLine.Command
import picocli.CommandLine.IVersionProvider
import picocli.CommandLine.Option

@Command(
    name = "argo",
    description = ["Tools for boards, filters and projects of ARGO.", ""],
    versionProvider = JarVersion::class,
    subcommands = [
        PortsCommand::class, DescribeCommand::class, MonitorCommand::class, RequestCommand::class, SendCommand::class, ReplayCommand::class,
        RecordingCommand::class, WhyCommand::class, ExploreCommand::class, FilterCommand::class, DoctorCommand::class,
        CheckCommand::class, NewCommand::class, ReloadCommand::class, DemoCommand::class, SampleCommand::class, ExperimentCommand::class,
        CompletionCommand::class,
    ],
    footer = ["", "COMMAND --help describes a command. Exit status: 0 done, 1 failed, 2 wrong arguments."],
)
internal class Tools : ToolCommand() {
    @Option(names = ["-V", "--version"], versionHelp = true, description = ["prints the version"])
    private var version = false

    override fun call(): Int = spec.refuseWithout("command")
}

internal class JarVersion : IVersionProvider {
    override fun getVersion() = arrayOf(
        "ARGO ${JarVersion::class.java.`package`.implementationVersion ?: "from a build directory"}, Java ${Runtime.version()}",
    )
}

@Command(
    name = "completion",
    description = [
        "Prints a completion script for bash and zsh.",
        "  alias argo='java -jar /path/to/argo.jar'; source <(argo completion)",
    ],
)
internal class CompletionCommand : ToolCommand() {
    override fun call(): Int {
        out.print(picocli.AutoComplete.bash("argo", allTools()))
        out.flush()
        return ExitStatus.DONE
    }
}
