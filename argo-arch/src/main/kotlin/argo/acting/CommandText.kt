package argo.acting

import argo.calls.ArgumentException
import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import argo.filters.jason.perceptText
import jason.asSyntax.ASSyntax
import jason.asSyntax.BinaryStructure
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.LiteralImpl
import jason.asSyntax.NumberTermImpl
import jason.asSyntax.StringTerm
import jason.asSyntax.Structure
import jason.asSyntax.Term
import javino.Frame
import javino.PerceptsRequest

/** Reads a person's command: a literal, or a string in quotes. Throws [ArgumentException] if [command] is neither. */
internal fun commandTerm(command: String): Term {
    val text = command.trim()
    try {
        if (!text.startsWith('"')) return PerceptReader.read(text)
        val only = PerceptReader.read("text($text)").terms.singleOrNull()
        return only as? StringTerm ?: throw ArgumentException("$text is more than one string in quotes")
    } catch (wrong: PerceptSyntaxException) {
        throw ArgumentException(if (text.startsWith('"')) "$text is no string in quotes" else wrong.message.orEmpty())
    }
}

/** Reads [text], a term that a link has written. */
internal fun termOf(text: String): Term = PerceptReader.read("answer($text)").getTerm(0) // the reader takes only literals

/** Throws [ArgumentException] if [command] is neither a string nor a literal, or if a literal has variables or infinite numbers. */
internal fun requireCommand(command: Term) {
    when {
        command is StringTerm -> if (command.string.isEmpty()) throw ArgumentException("a command has at least one character")
        !command.isGround || command is Literal && command.ns.isVar ->
            throw ArgumentException("$command holds a variable that has no value")
        command !is Literal || command.isList || command.isPlanBody || command is BinaryStructure ->
            throw ArgumentException("a command is a literal such as ledOn or speed(120), not $command")
        !isFinite(command) -> throw ArgumentException("$command holds a number that is infinite or none, as after a division by 0")
    }
}

private fun isFinite(term: Term): Boolean = when (term) {
    is NumberTermImpl -> term.solve().isFinite()
    is ListTerm -> term.all(::isFinite)
    is Structure -> (0 until term.arity).all { isFinite(term.getTerm(it)) }
    else -> true
}

/**
 * Returns the text to send for [command]: a string without its quotes, or a literal without its namespace. [requireCommand] must have
 * accepted [command]. For a line, writes the literal as Jason does, but escapes quotes in strings. Other links read the text back, so for
 * them strings are fully escaped.
 *
 * @param isLine whether the text goes out as bytes on a line, see [argo.links.BoardLink.isLine]
 * @throws ArgumentException if a line cannot carry the text
 */
internal fun commandText(command: Term, isLine: Boolean): String = when {
    isLine -> lineText(if (command is Literal) literalText(command) else (command as StringTerm).string)
    command is Literal -> perceptText(withoutNamespace(command))
    else -> (command as StringTerm).string
}

private fun lineText(text: String): String {
    if (PerceptsRequest.isIn(text)) {
        throw ArgumentException("a board takes $text for the request for percepts, which argo.percepts(open) sends, and not for a command")
    }
    try {
        return Frame.ofCommand(text).text()
    } catch (unsendable: IllegalArgumentException) {
        throw ArgumentException(unsendable.message.orEmpty())
    }
}

/** Returns [literal] as Jason writes it, without its namespace. Jason's own function is too slow on the way from percept to command. */
private fun literalText(literal: Literal): String = when {
    isPlain(literal) -> StringBuilder().also { literal.writeTo(it) }.toString()
    else -> withEscapes(withoutNamespace(literal)).toString()
}

private fun withoutNamespace(literal: Literal): Literal =
    if (literal.ns == Literal.DefaultNS) literal else literal.cloneNS(Literal.DefaultNS) as Literal

/** Returns true if [writeTo] can write [term], a functor with arguments and no annotations. */
private fun isPlain(term: Term) = term.javaClass in PLAIN && !(term as Literal).hasAnnot()

private fun Literal.writeTo(text: StringBuilder) {
    if (negated()) text.append('~')
    text.append(functor)
    for (place in 0 until arity) {
        text.append(if (place == 0) '(' else ',')
        val term = getTerm(place)
        if (isPlain(term) && (term as Literal).ns === Literal.DefaultNS) term.writeTo(text) else text.append(withEscapes(term))
    }
    if (arity > 0) text.append(')')
}

/** Escapes the quotes in the strings of [term]. Jason leaves them, and a board would take a quote for the end of the string. */
private fun withEscapes(term: Term): Term = when {
    term is StringTerm -> ASSyntax.createString(TO_ESCAPE.replace(term.string) { if (it.value.length > 1) it.value else "\\${it.value}" })
    term is ListTerm -> ASSyntax.createList(term.asList.map(::withEscapes))
    term.javaClass in PLAIN -> (term.clone() as Literal).apply {
        for (place in 0 until arity) setTerm(place, withEscapes(getTerm(place)))
        if (hasAnnot()) setAnnots(withEscapes(annots) as ListTerm)
    }
    else -> term
}

/** A quote, a backslash, or two backslashes. Jason keeps an escaped backslash as two characters, so a pair is already escaped. */
private val TO_ESCAPE = Regex("""\\\\|[\\"]""")

private val PLAIN = setOf<Class<*>>(LiteralImpl::class.java, Structure::class.java)
