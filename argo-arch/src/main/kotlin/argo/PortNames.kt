package argo

import argo.calls.ArgumentException
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import jason.asSyntax.VarTerm

/**
 * The name of the port that [term] stands for, as a transport takes it.
 * @throws ArgumentException if it stands for none
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

/** The port in the agent's beliefs: what it wrote, or for a variable its name as an atom if it can be one, else as a string. */
internal fun portTerm(written: Term, name: String): Term = if (written is VarTerm) ASSyntax.createString(name) else written
