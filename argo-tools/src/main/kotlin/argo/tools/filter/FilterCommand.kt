package argo.tools.filter

import argo.tools.command.ToolCommand
import argo.tools.command.refuseWithout
import picocli.CommandLine.Command

@Command(
    name = "filter",
    description = ["Checks, explains and converts files of perception filters."],
    subcommands = [FilterCheckCommand::class, FilterExplainCommand::class, FilterConvertCommand::class],
)
internal class FilterCommand : ToolCommand() {
    override fun call(): Int = spec.refuseWithout("command")
}
