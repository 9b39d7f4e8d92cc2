package argo.testkit

import argo.orders.unreadableAt
import jason.asSyntax.parser.ParseException
import jason.asSyntax.parser.TokenMgrError
import java.nio.file.Path
import kotlin.io.path.readLines

/** Calls [work], which reads the program in [file]. If Jason cannot read the program [called], the error names the place. */
internal fun <T> reading(file: Path?, called: String, work: () -> T): T = try {
    work()
} catch (unreadable: ParseException) {
    throw IllegalArgumentException("Jason cannot read $called: ${whatWasFound(unreadable, file)}", unreadable)
} catch (unreadable: TokenMgrError) {
    throw IllegalArgumentException("Jason cannot read $called: ${unreadable.message.orEmpty().trim()}", unreadable)
}

/** Returns the message with the faulty line, and a mark below the fault. */
private fun whatWasFound(unreadable: ParseException, file: Path?): String {
    val found = unreadable.currentToken?.next
    val line = found?.let { file?.readLines().orEmpty().getOrNull(it.beginLine - 1) } ?: return unreadableAt(unreadable)
    val mark = line.take(maxOf(0, found.beginColumn - 1)).map { if (it == '\t') '\t' else ' ' }.joinToString("") + "^"
    return "${unreadableAt(unreadable)}\n    $line\n    $mark"
}
