package argo

/**
 * The internal action `argo.ports(List)`: the agent perceives the boards on all ports of List, and no others. An element is a port as in
 * `argo.port`, or `port(P, Options)` with the options of `argo.port`: `[ttyACM0, port(ttyACM1, [as(left)]), "tcp://arm:4000"]`. The first
 * element is the port in use, which gets each command for which no board is found.
 *
 * Closed ports are opened in parallel, and each board is perceived as soon as its port is open. Boards in List that the agent already
 * perceives are not disturbed. A board that is not in List is no longer perceived, but its port stays open.
 *
 * The intention is suspended until each port is open or has failed. If some ports cannot be opened, the boards on the others are still
 * perceived. If a failed port was perceived before, its board stays perceived. If the device of this port has gone, ARGO searches for it.
 * Afterwards the plan fails with the error of the first failed port, like `argo.port`. The message lists all reasons. If no port can be
 * opened, nothing changes. Fails the plan also with `error(wrong_arguments)` or `error(not_argo)`.
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
