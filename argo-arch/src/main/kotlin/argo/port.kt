package argo

import argo.calls.Failure
import argo.connecting.PortOptions
import jason.asSyntax.Term
import jason.asSyntax.VarTerm

/**
 * The internal action `argo.port(P)` or `argo.port(P, Options)`: selects P as the only port for sensing and acting.
 *
 * P is an atom or a string: `ttyACM0`, `"/dev/serial/by-id/…"`, `COM8`, `"usb:2341:0043"`, `"tcp://robot:4000"`. An unbound variable means
 * its own name, as in programs for other versions of ARGO. `none` closes all ports of the agent. Options is a list of `baud(Rate)`,
 * `timeout(Ms)`, `mode(request)` or `mode(listen)`, `protocol(auto)`, `protocol(1)` or `protocol(2)`, `boot(Ms)`, `spacing(Ms)`,
 * `queue(Messages)`, `stale(Ms)`, `as(Namespace)`. Without Options, the agent's last options for P apply. With `as(left)` the board's
 * percepts are believed in the namespace `left`, as `left::dist(f,30)`. For several boards at once see `argo.ports`.
 *
 * The intention is suspended until the port is open. Other ports stay open. When the device of a lost port returns, the port is opened
 * again with its options. The state of P is the belief `port(P,on)`, `port(P,off)` or `port(P,timeout)`. If no message has arrived from P
 * for too long while the agent perceives, the agent believes `stale(P)`.
 *
 * Fails the plan, and keeps the port in use, with `error(wrong_arguments)`, `error(no_such_port)`, `error(port_busy)`,
 * `error(port_permission)`, `error(port_gone)`, `error(port_failed)`, `error(too_many_ports)` or, for an agent without [Arch],
 * `error(not_argo)`.
 */
@Suppress("ClassName")
open class port : BoardInternalAction("argo.port", 1..2) {
    override val suspends get() = true

    override fun run(call: Call) {
        val ports = call.arch.boards.ports
        val name = portName(call.args[0])
        val options = call.args.getOrNull(1)?.let(PortOptions::of)
        val outcome = call.suspendIntention()
        if (name == "none") ports.closeAll { outcome(null, null) }
        else ports.choose(portTerm(call.args[0], name), name, options) { outcome(it?.hinting(call.args[0]), null) }
    }
}

/** Adds a hint if the port was written as a variable. The program's author may have meant the variable's value. */
private fun Failure.hinting(written: Term): Failure =
    if (written !is VarTerm || error != "no_such_port") this
    else copy(cause = "$cause ($written has no value, so its name was taken for the port's)")
