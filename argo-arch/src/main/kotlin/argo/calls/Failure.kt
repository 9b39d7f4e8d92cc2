package argo.calls

import argo.links.errorOf
import argo.observing.CommandFailure
import jason.JasonException
import jason.asSyntax.ASSyntax
import javino.PortException

/**
 * The reason for which an internal action failed.
 *
 * @property error the atom in the annotation `error(…)` of the failed plan, for other plans to match
 * @property cause the finding and the remedy, for a person
 */
internal data class Failure(override val error: String, override val cause: String) : CommandFailure {
    /** Returns the exception that fails the plan of [call], such as `argo.act(ledOn)`. */
    fun of(call: String): JasonException = JasonException("$call: $cause", ASSyntax.createAtom(error))
}

/** The error if an answer was requested, and the board has none. */
internal const val NO_ANSWER = "no_answer"

/** Returns this failure. If the port's device has gone, the cause also says that ARGO searches for the device. */
internal fun Failure.whileLost(): Failure =
    if (error == "port_gone") copy(cause = "$cause; a device that was unplugged is looked for, and its port opened again") else this

internal fun wrongArgument(cause: String) = Failure("wrong_arguments", cause)

/**
 * Returns the failure of a plan for [trouble] with a port. If [trouble] is an exception that no transport should throw, its error is
 * `port_failed`.
 */
internal fun failureOf(trouble: Throwable): Failure = Failure(
    errorOf(trouble),
    if (trouble is PortException) trouble.message ?: trouble.javaClass.simpleName else "$trouble",
)
