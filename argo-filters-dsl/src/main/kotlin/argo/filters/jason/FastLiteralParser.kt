package argo.filters.jason

import argo.filters.Syntax
import argo.filters.TermCursor
import jason.asSyntax.ASSyntax
import jason.asSyntax.ArithExpr
import jason.asSyntax.Atom
import jason.asSyntax.ListTerm
import jason.asSyntax.ListTermImpl
import jason.asSyntax.Literal
import jason.asSyntax.LiteralImpl
import jason.asSyntax.NumberTerm
import jason.asSyntax.NumberTermImpl
import jason.asSyntax.SourceInfo
import jason.asSyntax.StringTermImpl
import jason.asSyntax.Term

/**
 * Reads one literal in a form that boards usually send. Returns null for text that needs Jason's full grammar: namespaces, variables,
 * operators, comments and reserved words.
 */
internal class FastLiteralParser(text: String) : TermCursor(text, 0, text.length) {

    /** Returns the literal that Jason's parser would return. Returns null if Jason's parser must read the text. */
    fun parse(): Literal? = literal()?.takeIf { blanks() == end }

    private fun literal(depth: Int = 0): Literal? {
        if (blanks() >= end || depth > MAX_DEPTH) return null
        val negated = take('~')
        blanks()
        val functor = functor() ?: return null
        val literal = LiteralImpl(Literal.DefaultNS, !negated, functor)
        literal.srcInfo = SOURCE
        if (take('(')) literal.setTerms(items { term(depth + 1) }?.takeIf { take(')') } ?: return null)
        if (take('[')) literal.setAnnots(list(depth) ?: return null)
        return literal
    }

    /** Reads a quoted atom, or a word that can only be an atom. A word with a dot may be an internal action or a function. */
    private fun functor(): String? {
        val start = at
        if (start >= end) return null
        if (text[start] == '\'') {
            at = Syntax.quotedAtomEnd(text, start, end)
            return if (at < 0) null else text.substring(start, at).takeUnless { '\n' in it || '\r' in it }
        }
        if (text[start] !in 'a'..'z') return null
        at = Syntax.wordEnd(text, start, end)
        val isSpecial = at < end && (text[at] == '.' || text[at] == ':') ||
            Syntax.isReserved(text, start, at) || Syntax.isTruthValue(text, start, at)
        return if (isSpecial) null else text.substring(start, at)
    }

    private fun list(depth: Int): ListTermImpl? {
        val list = ListTermImpl()
        if (take(']')) return list
        val items = items { term(depth + 1) } ?: return null
        items.fold<Term, ListTerm>(list) { last, item -> last.append(item) }
        return list.takeIf { take(']') }
    }

    private fun term(depth: Int): Term? {
        if (blanks() >= end || depth > MAX_DEPTH) return null
        return when {
            text[at] == '"' -> quoted()?.let { StringTermImpl(it).apply { srcInfo = SOURCE } }
            text[at] in '0'..'9' -> number()
            take('-') -> number()?.let { ArithExpr(ArithExpr.ArithmeticOp.minus, it) }
            take('[') -> list(depth)
            else -> structure(depth)
        }
    }

    private fun structure(depth: Int): Term? {
        val start = at
        val wordEnd = Syntax.wordEnd(text, start, end)
        if (Syntax.isTruthValue(text, start, wordEnd) && text.getOrNull(wordEnd) !in BEHIND_NAMES) {
            at = wordEnd
            return if (text[start] == 't') Literal.LTrue else Literal.LFalse
        }
        val literal = literal(depth) ?: return null
        if (!literal.isAtom) return literal
        return if (literal.functor in ATOMS_OF_JASON) null else Atom(literal)
    }

    private fun number(): NumberTerm? {
        if (blanks() >= end || text[at] !in '0'..'9') return null
        return double()?.let { NumberTermImpl(it).apply { srcInfo = SOURCE } }
    }

    /** Stops at line breaks and comments. A term contains its line number, so Jason's parser reads texts of several lines. */
    override fun blanks(): Int {
        while (at < end && (text[at] == ' ' || text[at] == '\t')) at++
        return at
    }

    private companion object {
        const val MAX_DEPTH = 64

        /** A word before one of these characters is only the beginning of a name or a structure. */
        val BEHIND_NAMES = setOf('.', ':', '(', '[')
        val ATOMS_OF_JASON = setOf("default", "this_ns")

        /** The source position that Jason's parser gives to terms in a text of one line. */
        val SOURCE: SourceInfo = ASSyntax.parseLiteral("a").srcInfo
    }
}
