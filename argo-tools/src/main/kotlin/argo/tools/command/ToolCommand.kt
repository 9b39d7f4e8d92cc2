package argo.tools.command

import argo.filters.withControlsShown
import picocli.CommandLine.Command
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Spec
import java.io.PrintWriter
import java.util.concurrent.Callable

/** The base class of all tools, including those of a [ToolProvider]. [call] returns the exit status, or throws a [ToolException]. */
@Command
abstract class ToolCommand : Callable<Int> {
    /** The picocli form of this command. */
    @Spec
    protected lateinit var spec: CommandSpec

    @Option(names = ["-h", "--help"], usageHelp = true, order = LAST, description = ["shows this"])
    private var help = false

    protected val out: PrintWriter get() = spec.commandLine().out

    protected val err: PrintWriter get() = spec.commandLine().err

    /** The colours. There are none if `NO_COLOR` is set, or on a terminal without colours. */
    internal val paint: Paint get() = Paint(spec.commandLine().colorScheme.ansi().enabled())

    /** Ends the command with exit status 2 because of wrong arguments, for [reason]. */
    protected fun misuse(reason: String): Nothing = spec.refuse(reason)

    /** Returns the user's options except those named [left], as arguments for another program. */
    internal fun givenWithout(vararg left: String): List<String> =
        spec.commandLine().parseResult.matchedOptions().filter { it.longestName() !in left }.flatMap { option ->
            val name = option.longestName()
            if (option.arity().max() == 0) listOf(name) else option.originalStringValues().map { "$name=$it" }
        }
}

/** The picocli order number that puts --help last. */
private const val LAST = 100

/** A tool that can print its results as JSON. */
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

/** Returns [text] as [withControlsShown] does, but keeps its lines. */
internal fun printableLines(text: String): String = text.lines().joinToString("\n", transform = ::withControlsShown)
