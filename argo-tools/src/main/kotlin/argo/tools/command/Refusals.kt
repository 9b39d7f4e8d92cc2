package argo.tools.command

import picocli.CommandLine
import picocli.CommandLine.ExitCode
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.ParameterException
import picocli.CommandLine.TypeConversionException
import picocli.CommandLine.UnmatchedArgumentException
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * Has the commands of this line tell a person what is wrong with their arguments, and where the help is, and end with exit status 2.
 *
 * @param kind what the commands are, in one word: `command`, `sample`
 */
fun CommandLine.refusingInWords(kind: String): CommandLine = this
    .registerConverter(Int::class.java) { wholeNumber(it, String::toIntOrNull) }
    .registerConverter(Int::class.javaObjectType) { wholeNumber(it, String::toIntOrNull) }
    .registerConverter(Long::class.javaObjectType) { wholeNumber(it, String::toLongOrNull) }
    .registerConverter(Path::class.java, ::file)
    .setParameterExceptionHandler { wrong, _ ->
        val refused = wrong.commandLine
        refused.err.println(reason(wrong, kind))
        refused.err.println("${refused.commandSpec.qualifiedName()} --help shows what there is")
        ExitCode.USAGE
    }

private fun <N> wholeNumber(text: String, read: (String) -> N?): N =
    read(text) ?: throw TypeConversionException("$text is not a whole number that can be used here")

private fun file(name: String): Path = try {
    Path.of(name)
} catch (_: InvalidPathException) {
    throw TypeConversionException("'$name' has characters that no file's name has here; if it is there, the locale (LC_ALL or LANG) is to be one of UTF-8")
}

private fun reason(wrong: ParameterException, kind: String): String? {
    val surplus = (wrong as? UnmatchedArgumentException)?.takeUnless { it.isUnknownOption }?.unmatched?.firstOrNull()
    val commands = wrong.commandLine.subcommands.keys
    return when {
        surplus == null -> wrong.message
        commands.isEmpty() -> "there is nothing to do with '$surplus' here"
        else -> "there is no $kind '$surplus'; there are: ${commands.joinToString()}"
    }
}

/** Ends this command, whose arguments cannot be used because of [reason]. */
fun CommandSpec.refuse(reason: String): Nothing = throw ParameterException(commandLine(), reason)

/** Refuses a [value] of [option] that is not in [range]; [unit] is what stands behind the range in words. */
fun CommandSpec.requireWithin(option: String, value: Int, range: IntRange, unit: String = "") {
    if (value !in range) refuse("$option is from ${range.first} to ${range.last}${if (unit.isEmpty()) "" else " $unit"}, not $value")
}

/** Refuses a call without one of this command's own commands, each of which is a [kind]. */
fun CommandSpec.refuseWithout(kind: String): Nothing = refuse("name a $kind: ${subcommands().keys.joinToString()}")
