package argo

import argo.calls.ArgumentException
import argo.connecting.PortOptions
import argo.connecting.WantedPort
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.Term

/**
 * The internal action `argo.ports(List)`: the agent perceives the boards on all ports of List, and no others. An element is a port as in
 * `argo.port`, or `port(P, Options)` with the options of `argo.port`: `[ttyACM0, port(ttyACM1, [as(left)]), "tcp://arm:4000"]`. The first
 * element is the port in use: it gets commands that no other board is found for.
 *
 * Closed ports are opened all at once, and each board is perceived as soon as its port is open. A perceived board in List is not disturbed.
 * A board that is not in List is no longer perceived, but its port stays open.
 *
 * The intention is suspended until each port is open or has failed. If some ports cannot be opened, the boards on the others are still
 * perceived. If such a board was perceived before, it stays so, and is searched for if its device has gone. Then the plan fails with the
 * error of the first failed port, like `argo.port`; the message has all reasons. If no port can be opened, nothing changes. Fails the plan
 * also with `error(wrong_arguments)` or `error(not_argo)`.
 */
@Suppress("ClassName")
open class ports : BoardInternalAction("argo.ports", 1..1) {
    override val suspends get() = true

    override fun run(call: Call) {
        val ports = call.arch.boards.ports
        val wanted = wantedPorts(call.args[0])
        val outcome = call.suspendIntention()
        ports.chooseAll(wanted) { outcome(it, null) }
    }
}

/** Reads the [list] of ports of `argo.ports`. Throws [ArgumentException] if it is none. */
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
