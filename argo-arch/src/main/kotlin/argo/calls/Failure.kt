package argo.calls

import argo.links.errorOf
import argo.observing.CommandFailure
import jason.JasonException
import jason.asSyntax.ASSyntax
import javino.PortException

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
internal fun failureOf(trouble: Throwable): Failure = Failure(
    errorOf(trouble),
    if (trouble is PortException) trouble.message ?: trouble.javaClass.simpleName else "$trouble",
)
