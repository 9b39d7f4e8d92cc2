package argo

import argo.boards.AgentBoards
import argo.boards.Board
import argo.calls.ArgumentException
import argo.calls.optionsIn
import argo.connecting.PortOptions
import argo.connecting.WantedPort
import jason.asSyntax.ASSyntax
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import jason.asSyntax.VarTerm

/** Returns the name by which a transport opens the port [term]. Throws [ArgumentException] if [term] names no port. */
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

/** Returns the port's term for the agent's beliefs. If [written] is a variable, returns [name] as a string, else [written]. */
internal fun portTerm(written: Term, name: String): Term = if (written is VarTerm) ASSyntax.createString(name) else written

/**
 * Returns the board that the second argument of [call] names, as in `[port(P)]`; null if the call names none. Throws [ArgumentException] if
 * the argument has other options or several ports.
 */
internal fun boardIn(call: BoardInternalAction.Call): Board? {
    val ports = optionsIn(call.args.getOrNull(1) ?: return null, "[port(ttyACM0)]").map(::portIn)
    if (ports.size > 1) throw ArgumentException("the options name ${ports.size} ports; a call takes one port(P)")
    val port = ports.singleOrNull() ?: return null
    return call.arch.boards.named(port) ?: throw call.failure("unknown_board", unknownBoard(port, call.arch.boards))
}

private fun portIn(option: Term): Term = (option as? Literal)?.takeIf { !it.isVar && it.functor == "port" && it.arity == 1 }?.getTerm(0)
    ?: throw ArgumentException("$option is not an option; the only option is port(P)")

internal fun unknownBoard(port: Term, boards: AgentBoards): String =
    "there is no board on port $port; the agent perceives ${boards.current.joinToString { "${it.term}" }.ifEmpty { "none" }}"

/** Reads [list], the argument of `argo.ports`. Throws [ArgumentException] if [list] is no list of ports. */
internal fun wantedPorts(list: Term): List<WantedPort> = elements(list).map(::wantedPort).distinct().also { wanted ->
    wanted.groupBy { "${it.term}" }.values.find { it.size > 1 }?.let {
        throw ArgumentException("the port ${it.first().term} is in the list twice, with different options")
    }
}

private fun elements(list: Term): List<Term> = (list as? ListTerm)?.takeIf { it.isList && it.tail == null && !it.isEmpty() }?.asList
    ?: throw ArgumentException("the argument is a list of ports such as [ttyACM0, port(ttyACM1,[as(left)])], not $list")

private fun wantedPort(element: Term): WantedPort {
    val isPort = element is Literal && !element.isVar && !element.isList && element.functor == "port" && element.arity in 1..2
    val term = if (isPort) element.getTerm(0) else element
    val options = if (isPort && element.arity == 2) PortOptions.of(element.getTerm(1)) else null
    val name = portName(term)
    if (name == "none") throw ArgumentException("none is no port in a list; argo.port(none) closes all ports")
    return WantedPort(portTerm(term, name), name, options)
}
