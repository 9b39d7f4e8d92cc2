package argo

import argo.calls.ArgumentException
import argo.connecting.PortOptions
import argo.connecting.WantedPort
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.Term

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
