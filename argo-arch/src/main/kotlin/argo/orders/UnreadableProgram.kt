package argo.orders

import jason.asSyntax.parser.ParseException

/**
 * Returns a message that says where Jason cannot read a program. The message of [unreadable] itself is too long, since it lists about forty
 * tokens that Jason would have accepted.
 */
fun unreadableAt(unreadable: ParseException): String {
    val found = unreadable.currentToken?.next ?: return unreadable.message.orEmpty()
    if (found.kind == END) return "it ends in the middle, in line ${found.beginLine}"
    return "\"${found.image}\" does not belong in line ${found.beginLine}, column ${found.beginColumn}, or something before it is missing"
}

private const val END = 0 // the kind of the last token in every JavaCC parser
