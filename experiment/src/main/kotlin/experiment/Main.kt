package experiment

import argo.tools.command.refusingInWords
import experiment.delegation.DelegationCommand
import picocli.CommandLine
import kotlin.system.exitProcess

/**
 * Makes the experiment, and ends the program with its exit status, which is 2 for wrong arguments. The property `argo.command` contains the
 * words that the user has typed before `experiment`.
 */
fun main(args: Array<String>) {
    exitProcess(program().execute(*args))
}

internal fun program(): CommandLine {
    val name = "${System.getProperty("argo.command") ?: "./argo"} experiment"
    return CommandLine(ExperimentCommand()).addSubcommand(DelegationCommand()).setCommandName(name).refusingInWords("command")
}
