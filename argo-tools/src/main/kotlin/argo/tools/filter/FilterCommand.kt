package argo.tools.filter

import argo.tools.command.refuseWithout
import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Spec

@Command(
    name = "filter",
    description = ["Checks, explains and converts files of perception filters."],
    subcommands = [FilterCheckCommand::class, FilterExplainCommand::class, FilterConvertCommand::class],
)
internal class FilterCommand : Runnable {
    @Spec
    private lateinit var spec: CommandSpec

    @Option(names = ["-h", "--help"], usageHelp = true, description = ["shows this"])
    private var help = false

    override fun run(): Unit = spec.refuseWithout("command")
}
