package argo

import argo.calls.ArgumentException
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import jason.asSyntax.VarTerm

/**
 * Returns the name of the port [term] in the form for a transport.
 * @throws ArgumentException if it names no port
 */
internal fun portName(term: Term): String {
    val name = when {
        term is VarTerm -> term.functor
        term is StringTerm -> term.string
        term is Literal && term.isAtom -> term.functor
        else -> throw ArgumentException("a port is an atom such as ttyACM0 or a string such as \"/dev/ttyACM0\", not $term")
    }
    if (term is VarTerm && name.startsWith("_")) throw ArgumentException("the variable for the port has no value")
    if (name.isBlank()) throw ArgumentException("the port has no name")
    return name
}

/** Returns the port for the agent's beliefs: the term [written], or for a variable its name, as an atom if possible, else as a string. */
internal fun portTerm(written: Term, name: String): Term = if (written is VarTerm) ASSyntax.createString(name) else written
