package argo.tools

import argo.tools.command.ExitStatus
import argo.tools.command.ToolProvider
import argo.tools.command.WatchedOutput
import argo.tools.command.refusingInWords
import argo.tools.command.standardCharset
import javino.Services
import picocli.CommandLine
import picocli.CommandLine.Help.Ansi
import java.io.FileDescriptor
import java.io.FileOutputStream
import java.io.OutputStream
import java.io.PrintWriter
import java.util.Locale
import kotlin.system.exitProcess

/**
 * Runs the tool that the arguments name. Ends the program with the tool's exit status: 0 for success, 1 for failure, 2 for wrong arguments.
 * The property `argo.command` contains the command as typed by the user.
 */
fun main(args: Array<String>) {
    val command = System.getProperty("argo.command") ?: "java -jar argo.jar"
    Locale.setDefault(Locale.Category.FORMAT, Locale.ROOT) // numbers are printed as options and questions take them, with a point
    System.setOut(System.err) // only results go to the standard output; agents in a replay and code of projects may print to System.out
    exitProcess(run(args, FileOutputStream(FileDescriptor.out), tools().setCommandName(command)))
}

/** Runs the tool that [arguments] name and writes its results to [target]. Returns the exit status. */
internal fun run(arguments: Array<String>, target: OutputStream, tools: CommandLine): Int {
    val output = WatchedOutput(target)
    tools.setOut(PrintWriter(output.bufferedWriter(standardCharset()), true))
    val status = tools.execute(*arguments)
    tools.out.flush()
    val trouble = output.trouble ?: return status
    if (!output.hasReaderGone) tools.err.println("the results could not be written: ${trouble.message}")
    return if (status == ExitStatus.DONE) ExitStatus.FAILED else status
}

internal fun tools(): CommandLine = allTools()
    .refusingInWords("command")
    .setColorScheme(CommandLine.Help.defaultColorScheme(if (System.getenv("TERM") == "dumb") Ansi.OFF else Ansi.AUTO))

internal fun allTools(): CommandLine = CommandLine(Tools()).apply {
    val others = Services.providers(ToolProvider::class.java).distinctBy { it.type() }.mapNotNull { Services.make(it) }
    others.forEach { addSubcommand(it.command()) }
}
