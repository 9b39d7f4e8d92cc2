package argo.tools.command

import argo.check.rules.editDistance
import picocli.CommandLine
import picocli.CommandLine.ExitCode
import picocli.CommandLine.MissingParameterException
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.ParameterException
import picocli.CommandLine.TypeConversionException
import picocli.CommandLine.UnmatchedArgumentException
import java.math.BigDecimal
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * Makes all commands of this program report failures in words. The exit status is then 1. For wrong arguments, they also mention the help.
 * The exit status is then 2.
 *
 * @param kind the word for a command of this program, `command` or `sample`
 */
fun CommandLine.refusingInWords(kind: String): CommandLine = this
    .registerConverter(Int::class.java) { wholeNumber(it, String::toIntOrNull) }
    .registerConverter(Int::class.javaObjectType) { wholeNumber(it, String::toIntOrNull) }
    .registerConverter(Long::class.javaObjectType) { wholeNumber(it, String::toLongOrNull) }
    .registerConverter(BigDecimal::class.java) { it.toBigDecimalOrNull() ?: throw TypeConversionException("$it is not a number") }
    .registerConverter(Path::class.java, ::file)
    .setExecutionExceptionHandler { failure, command, _ ->
        val message = messageOf(failure)
        if (message != null) command.err.println(printableLines(message)) else failure.printStackTrace(command.err)
        ExitStatus.FAILED
    }
    .setParameterExceptionHandler { wrong, _ ->
        val refused = wrong.commandLine
        refused.err.println(printableLines(reason(wrong, kind)))
        refused.err.println("${refused.commandSpec.qualifiedName()} --help lists the options")
        ExitCode.USAGE
    }

private fun <N> wholeNumber(text: String, read: (String) -> N?): N =
    read(text) ?: throw TypeConversionException("$text is not a whole number, or is too large")

private fun file(name: String): Path = try {
    Path.of(name)
} catch (_: InvalidPathException) {
    throw TypeConversionException("'$name' has characters that no file name has here; if it exists, set a UTF-8 locale (LC_ALL or LANG)")
}

private fun reason(wrong: ParameterException, kind: String): String {
    val surplus = (wrong as? UnmatchedArgumentException)?.takeUnless { it.isUnknownOption }?.unmatched?.firstOrNull()
    val commands = wrong.commandLine.subcommands.keys
    // Picocli may report an unknown option as a missing argument.
    val isUnknownOption = wrong is MissingParameterException || wrong is UnmatchedArgumentException && wrong.isUnknownOption
    val unknown = if (isUnknownOption) wrong.commandLine.unmatchedArguments.find { it.startsWith("-") } else null
    return when {
        unknown != null -> {
            val options = wrong.commandLine.commandSpec.optionsMap().keys.filter { it.startsWith("--") }
            val meant = closest(unknown.substringBefore('='), options)?.let { "; did you mean $it?" }.orEmpty()
            "Unknown option: '$unknown'$meant"
        }
        surplus == null -> wrong.message.orEmpty()
        commands.isEmpty() -> "'$surplus' is one argument too many"
        surplus in commands -> "'$surplus' stands behind --, where no command does; leave -- out"
        else -> {
            val meant = closest(surplus, commands)?.let { "did you mean $it? " }.orEmpty()
            "there is no $kind '$surplus'; ${meant}there are: ${commands.joinToString()}"
        }
    }
}

/** Returns the name in [names] that [word] probably means, or null if there is none. Only case or one or two letters may differ. */
private fun closest(word: String, names: Collection<String>): String? {
    fun distanceTo(name: String) = editDistance(word.lowercase(), name.lowercase())
    return names.minByOrNull(::distanceTo)?.takeIf { distanceTo(it) <= if (word.length > LONG) 2 else 1 }
}

private const val LONG = 4

/** Ends this command because of wrong arguments, for [reason]. */
fun CommandSpec.refuse(reason: String): Nothing = throw ParameterException(commandLine(), reason)

/** Refuses a [value] of [option] outside [range]. The message shows [unit] behind the range. */
fun CommandSpec.requireWithin(option: String, value: Int, range: IntRange, unit: String = "") {
    if (value !in range) refuse("$option is from ${range.first} to ${range.last}${if (unit.isEmpty()) "" else " $unit"}, not $value")
}

/** Refuses a call without a subcommand. [kind] is the word for a subcommand. */
fun CommandSpec.refuseWithout(kind: String): Nothing = refuse("name a $kind: ${subcommands().keys.joinToString()}")
