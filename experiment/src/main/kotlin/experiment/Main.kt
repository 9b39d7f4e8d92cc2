package experiment

import argo.tools.command.refusingInWords
import experiment.delegation.DelegationCommand
import picocli.CommandLine
import kotlin.system.exitProcess

/**
 * Runs the experiment, and ends the program with its exit status. Wrong arguments give 2. The property `argo.command` contains the words
 * that the user typed before `experiment`.
 */
fun main(args: Array<String>) {
    exitProcess(program().execute(*args))
}

internal fun program(): CommandLine {
    val name = "${System.getProperty("argo.command") ?: "./argo"} experiment"
    return CommandLine(ExperimentCommand()).addSubcommand(DelegationCommand()).setCommandName(name).refusingInWords("command")
}
