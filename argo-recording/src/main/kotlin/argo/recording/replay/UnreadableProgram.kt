package argo.recording.replay

import jason.asSyntax.parser.ParseException

/**
 * Where Jason cannot read a program and what stands there, for a person. The message of [unreadable] has what Jason would have accepted
 * instead: some forty kinds of token.
 */
fun unreadableAt(unreadable: ParseException): String {
    val found = unreadable.currentToken?.next ?: return unreadable.message.orEmpty()
    if (found.kind == END) return "it ends in the middle, in line ${found.beginLine}"
    return "\"${found.image}\" does not belong in line ${found.beginLine}, column ${found.beginColumn}, or something before it is missing"
}

private const val END = 0 // as in all parsers by JavaCC
