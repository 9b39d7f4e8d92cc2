package argo.tools.command

import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Spec
import java.io.PrintWriter
import java.util.concurrent.Callable

/** The base of all tools, including those of a [ToolProvider]. [call] returns the exit status, or fails by a [ToolException]. */
@Command
abstract class ToolCommand : Callable<Int> {
    /** The command in picocli's form. */
    @Spec
    protected lateinit var spec: CommandSpec

    @Option(names = ["-h", "--help"], usageHelp = true, order = LAST, description = ["shows this"])
    private var help = false

    /** The output for results. */
    protected val out: PrintWriter get() = spec.commandLine().out

    /** The output for errors. */
    protected val err: PrintWriter get() = spec.commandLine().err

    /** Colours; none if `NO_COLOR` is set, or on a terminal without colours. */
    internal val paint: Paint get() = Paint(spec.commandLine().colorScheme.ansi().enabled())

    /** Ends the command with exit status 2, since its arguments are wrong for [reason]. */
    protected fun misuse(reason: String): Nothing = spec.refuse(reason)

    /** Returns the user's options, without those called [left], as arguments for another program. */
    internal fun givenWithout(vararg left: String): List<String> =
        spec.commandLine().parseResult.matchedOptions().filter { it.longestName() !in left }.flatMap { option ->
            val name = option.longestName()
            if (option.arity().max() == 0) listOf(name) else option.originalStringValues().map { "$name=$it" }
        }
}

/** An order that puts --help last if a command shows its options in the order of their declaration. */
private const val LAST = 100

/** A tool whose results are data. */
@Command
internal abstract class DataCommand : ToolCommand() {
    @Option(names = ["--json"], description = ["prints JSON"])
    protected var json = false
}

internal class Paint(private val enabled: Boolean) {
    fun good(text: String) = paint("32", text)

    fun doubtful(text: String) = paint("33", text)

    fun bad(text: String) = paint("31", text)

    fun new(text: String) = paint("1", text)

    fun aside(text: String) = paint("2", text)

    private fun paint(code: String, text: String) = if (enabled) "\u001B[${code}m$text\u001B[0m" else text
}

/** Makes [text] from a board or a file safe to print: control characters, which could command a terminal, become `\u001B` and so on. */
internal fun printable(text: String): String =
    if (text.none(Char::isISOControl)) text else text.map { if (it.isISOControl()) "\\u%04X".format(it.code) else "$it" }.joinToString("")
