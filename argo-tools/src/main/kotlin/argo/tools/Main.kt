package argo.tools

import picocli.CommandLine
import picocli.CommandLine.ParameterException
import picocli.CommandLine.UnmatchedArgumentException
import java.io.FileDescriptor
import java.io.FileOutputStream
import java.io.PrintWriter
import java.nio.charset.Charset
import kotlin.system.exitProcess

/** Runs the tool that the arguments name, and ends the program with its exit status: 0 done, 1 failed, 2 wrong arguments. The property `argo.command` is what has been typed to run it. */
fun main(args: Array<String>) {
    val commands = tools().setOut(standardOut()).setCommandName(System.getProperty("argo.command") ?: "java -jar argo.jar")
    val status = commands.execute(*args)
    commands.out.flush()
    exitProcess(status)
}

/** Unlike `System.out`, it knows when the reader has gone, as in `monitor PORT | head`. */
private fun standardOut(): PrintWriter {
    val encoding = listOf("stdout.encoding", "sun.stdout.encoding", "native.encoding").firstNotNullOfOrNull(System::getProperty)
    val charset = if (encoding != null && Charset.isSupported(encoding)) Charset.forName(encoding) else Charset.defaultCharset()
    return PrintWriter(FileOutputStream(FileDescriptor.out).bufferedWriter(charset), true)
}

/** The tools, to be run in this program or in a test. */
internal fun tools(): CommandLine = CommandLine(Tools())
    .registerConverter(Int::class.java) { it.toIntOrNull() ?: throw CommandLine.TypeConversionException("$it is not a whole number that can be used here") }
    .setParameterExceptionHandler { wrong, _ ->
        val refused = wrong.commandLine
        refused.err.println(reason(wrong))
        refused.err.println("${refused.commandSpec.qualifiedName()} --help shows what there is")
        ExitStatus.USAGE
    }
    .setExecutionExceptionHandler { failure, command, _ ->
        val said = saidTo(failure)
        if (said != null) command.err.println(said) else failure.printStackTrace(command.err)
        ExitStatus.FAILED
    }

private fun reason(wrong: ParameterException): String? {
    val surplus = (wrong as? UnmatchedArgumentException)?.takeUnless { it.isUnknownOption }?.unmatched?.firstOrNull()
    val commands = wrong.commandLine.subcommands.keys
    return when {
        surplus == null -> wrong.message
        commands.isEmpty() -> "there is nothing to do with '$surplus' here"
        else -> "there is no command '$surplus'; there are: ${commands.joinToString()}"
    }
}
