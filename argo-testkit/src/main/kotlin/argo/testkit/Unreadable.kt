package argo.testkit

import jason.asSyntax.parser.ParseException
import jason.asSyntax.parser.TokenMgrError
import java.nio.file.Path
import kotlin.io.path.readLines

/** Does [work] with the program in [file], whose name in messages is [called]; reports where Jason cannot read it. */
internal fun <T> reading(file: Path?, called: String, work: () -> T): T = try {
    work()
} catch (unreadable: ParseException) {
    throw IllegalArgumentException("Jason cannot read $called: ${whatWasFound(unreadable, file)}", unreadable)
} catch (unreadable: TokenMgrError) {
    throw IllegalArgumentException("Jason cannot read $called: ${unreadable.message.orEmpty().trim()}", unreadable)
}

/** What Jason would have accepted instead is in the exception itself: some forty kinds of token. */
private fun whatWasFound(unreadable: ParseException, file: Path?): String {
    val found = unreadable.currentToken?.next ?: return unreadable.message.orEmpty()
    val line = file?.readLines().orEmpty().getOrNull(found.beginLine - 1) ?: return "it ends in the middle, in line ${found.beginLine}"
    val mark = line.take(maxOf(0, found.beginColumn - 1)).map { if (it == '\t') '\t' else ' ' }.joinToString("") + "^"
    return "\"${found.image}\" does not belong in line ${found.beginLine}, column ${found.beginColumn}, " +
        "or something before it is missing\n    $line\n    $mark"
}
