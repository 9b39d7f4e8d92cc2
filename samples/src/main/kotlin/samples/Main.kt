package samples

import picocli.CommandLine
import picocli.CommandLine.Command
import picocli.CommandLine.ExitCode
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.TypeConversionException
import samples.collision.CollisionCommand
import samples.lamp.BlinkCommand
import samples.lamp.TwoBoardsCommand
import samples.delegation.DelegationCommand
import samples.typedfilters.TypedFiltersCommand
import kotlin.system.exitProcess

/** Runs the sample that the arguments name and ends the program with its exit status; 2 for wrong arguments. */
fun main(args: Array<String>): Unit = exitProcess(commandLine().execute(*args))

private fun commandLine() = CommandLine(Samples())
    .registerConverter(Int::class.java, ::wholeNumber)
    .setParameterExceptionHandler { wrong, _ ->
        val command = wrong.commandLine
        command.err.println(wrong.message)
        command.err.println("${command.commandSpec.qualifiedName()} --help shows what there is")
        ExitCode.USAGE
    }

private fun wholeNumber(text: String): Int = text.toIntOrNull() ?: throw TypeConversionException("$text is not a whole number that can be used here")

@Command(
    name = "samples",
    description = ["Jason agents that drive boards through ARGO."],
    subcommands = [CollisionCommand::class, BlinkCommand::class, DelegationCommand::class, TwoBoardsCommand::class, TypedFiltersCommand::class],
)
private class Samples : Runnable {
    @CommandLine.Spec
    private lateinit var spec: CommandLine.Model.CommandSpec

    @Option(names = ["-h", "--help"], usageHelp = true, description = ["shows this"])
    private var help = false

    override fun run(): Unit = throw ParameterException(spec.commandLine(), "name a sample: ${spec.subcommands().keys.joinToString()}")
}
