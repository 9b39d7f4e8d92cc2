package samples

import argo.tools.command.ToolCommand
import argo.tools.command.refuseWithout
import argo.tools.command.refusingInWords
import picocli.CommandLine
import picocli.CommandLine.Command
import samples.collision.CollisionCommand
import samples.fleet.FleetCommand
import samples.lamp.BlinkCommand
import samples.project.MasRun
import samples.project.SampleProject
import samples.turtle.TurtleCommand
import kotlin.system.exitProcess

/**
 * Runs the sample that the arguments name. Ends the program with its exit status, which is 2 for wrong arguments. `demo` runs the sample
 * `collision`. The property `argo.command` contains the words that the user typed before the command's name.
 */
fun main(args: Array<String>) {
    val (commands, arguments) = program(args)
    exitProcess(commands.execute(*arguments))
}

internal fun program(args: Array<String>): Pair<CommandLine, Array<String>> {
    val rest = args.drop(1).toTypedArray()
    return when (args.firstOrNull()) {
        "demo" -> CommandLine(CollisionCommand()).named("demo") to rest
        else -> samples().named("sample") to args
    }
}

private fun CommandLine.named(name: String) =
    setCommandName("${System.getProperty("argo.command") ?: "./argo"} $name").refusingInWords("sample")

private fun samples() = CommandLine(Samples()).addSubcommand(CollisionCommand()).addSubcommand(BlinkCommand())
    .addProject(
        "delegation",
        "An ARGO agent that only senses and acts, and two common Jason agents that reason on what it tells them.",
        "The robot is the simulated one of the sample collision.",
    )
    .addProject("two-boards", "One agent that works with two boards in turn, by changing its port at run time. The boards are simulated.")
    .addProject("three-boards", "A robot of three boards, wheels, sensors and an arm, fetches a can. The boards are simulated.")
    .addProject("greenhouse", "An agent keeps a simulated greenhouse for a day, which takes a quarter of a minute, and obeys a person.")
    .addProject("sensing-agents", "A robot of three boards with an ARGO agent for each kind of its sensors. The boards are simulated.")
    .addSubcommand(TurtleCommand())
    .addProject(
        "typed-filters",
        "An agent looks at the world through filters that are written in Kotlin, and asks why it misses what it misses.",
        "The robot is the simulated one of the sample collision.",
    )
    .addSubcommand(FleetCommand())

private fun CommandLine.addProject(name: String, vararg description: String): CommandLine {
    val sample = CommandLine(ProjectCommand(name))
    sample.commandSpec.usageMessage().description(*description)
    return addSubcommand(name, sample)
}

@Command
private class ProjectCommand(private val name: String) : ToolCommand() {
    override fun call(): Int = MasRun(SampleProject(name)).toItsEnd()
}

@Command(name = "samples", description = ["Jason agents that drive boards through ARGO."])
private class Samples : ToolCommand() {
    override fun call(): Int = spec.refuseWithout("sample")
}
