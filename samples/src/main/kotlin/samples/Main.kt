package samples

import argo.tools.command.refuseWithout
import argo.tools.command.refusingInWords
import picocli.CommandLine
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import samples.carrier.ThreeBoardsCommand
import samples.collision.CollisionCommand
import samples.delegation.DelegationCommand
import samples.fleet.FleetCommand
import samples.lamp.BlinkCommand
import samples.lamp.TwoBoardsCommand
import samples.turtle.TurtleCommand
import samples.typedfilters.TypedFiltersCommand
import kotlin.system.exitProcess

/**
 * Runs the sample that the arguments name and ends the program with its exit status; 2 for wrong arguments. `demo` runs the sample
 * `collision`. The property `argo.command` has the words that the user has typed before the name of the command.
 */
fun main(args: Array<String>) {
    val (commands, arguments) = program(args)
    exitProcess(commands.execute(*arguments))
}

/** Returns the program that [args] name, and its own arguments. */
internal fun program(args: Array<String>): Pair<CommandLine, Array<String>> {
    val rest = args.drop(1).toTypedArray()
    return when (args.firstOrNull()) {
        "demo" -> commandLine(CollisionCommand(), "demo") to rest
        else -> commandLine(Samples(), "sample") to args
    }
}

private fun commandLine(command: Any, name: String) =
    CommandLine(command).setCommandName("${System.getProperty("argo.command") ?: "./argo"} $name").refusingInWords("sample")

@Command(
    name = "samples",
    description = ["Jason agents that drive boards through ARGO."],
    subcommands = [
        CollisionCommand::class, BlinkCommand::class, DelegationCommand::class, TwoBoardsCommand::class, ThreeBoardsCommand::class,
        TurtleCommand::class, TypedFiltersCommand::class, FleetCommand::class,
    ],
)
private class Samples : Runnable {
    @CommandLine.Spec
    private lateinit var spec: CommandLine.Model.CommandSpec

    @Option(names = ["-h", "--help"], usageHelp = true, description = ["shows this"])
    private var help = false

    override fun run(): Unit = spec.refuseWithout("sample")
}
