package argo.links

import javino.ActionFailedException
import javino.ActionRefusedException
import javino.ActionUnconfirmedException
import javino.CommandReplacedException
import javino.CommandWithdrawnException
import javino.NoSuchPortException
import javino.PortBusyException
import javino.PortGoneException
import javino.PortPermissionException
import javino.PortTimeoutException

/** Returns the atom in `error(…)` for [trouble] with a port or a command. An exception of any other kind is `port_failed`. */
fun errorOf(trouble: Throwable): String = when (trouble) {
    is NoSuchPortException -> "no_such_port"
    is PortBusyException -> "port_busy"
    is PortPermissionException -> "port_permission"
    is PortGoneException -> "port_gone"
    is PortTimeoutException -> "port_timeout"
    is ActionRefusedException -> "act_refused"
    is ActionFailedException -> "act_failed"
    is ActionUnconfirmedException -> "act_unconfirmed"
    is CommandWithdrawnException -> "act_timeout"
    is CommandReplacedException -> "act_replaced"
    else -> "port_failed"
}
