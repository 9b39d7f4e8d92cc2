package argo.calls

import argo.observing.CommandFailure
import jason.JasonException
import jason.asSyntax.ASSyntax
import javino.ActionFailedException
import javino.ActionRefusedException
import javino.ActionUnconfirmedException
import javino.CommandReplacedException
import javino.CommandWithdrawnException
import javino.NoSuchPortException
import javino.PortBusyException
import javino.PortException
import javino.PortGoneException
import javino.PortPermissionException
import javino.PortTimeoutException

/**
 * Why an internal action could not do what it was asked.
 *
 * @property error the atom in the annotation `error(…)` of the failed plan, for other plans to match
 * @property cause what was found and what to do, for a person
 */
internal data class Failure(override val error: String, override val cause: String) : CommandFailure {
    /** The exception that fails the plan which called [call], such as `argo.act(ledOn)`. */
    fun of(call: String): JasonException = JasonException("$call: $cause", ASSyntax.createAtom(error))
}

/** This failure of a command, with what becomes of a port whose device has gone. */
internal fun Failure.whileLost(): Failure =
    if (error == "port_gone") copy(cause = "$cause; a device that was unplugged is looked for, and its port opened again") else this

/** The argument is not of the kind that the action takes. */
internal fun wrongArgument(cause: String) = Failure("wrong_arguments", cause)

/** What [trouble] with a port means to a plan; what no transport should throw is `port_failed` too. */
internal fun failureOf(trouble: Throwable): Failure =
    if (trouble is PortException) failureOf(trouble) else Failure("port_failed", "$trouble")

private fun failureOf(trouble: PortException): Failure = Failure(
    when (trouble) {
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
    },
    trouble.message ?: trouble.javaClass.simpleName,
)
