package argo.recording.agent

import argo.boundary.InternalCall
import argo.observing.CommandFailure
import argo.recording.CallFailure
import argo.recording.End
import argo.recording.Mail
import jason.JasonException
import jason.NoValueException
import jason.asSemantics.ActionExec
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Structure

/** The operations that an agent has begun outside of its thread and that have not ended. Only for the agent's thread. */
internal class PendingOperations {
    private val open = HashMap<Int, (End) -> Unit>()

    var last = 0
        private set

    val numbers: Set<Int> get() = open.keys

    /** Numbers the next operations from [last] on. The operations in [open] have not ended. */
    fun restore(last: Int, open: Map<Int, (End) -> Unit>) {
        this.last = last
        this.open.putAll(open)
    }

    /** Adds an operation, and returns its number. [complete] is later called with the operation's end. */
    fun begin(complete: (End) -> Unit): Int = (++last).also { open[it] = complete }

    /** Carries [end] out. Returns false if no open operation has its number. */
    fun carryOut(end: End): Boolean = open.remove(end.number)?.let { it(end) } != null
}

internal fun complete(action: ActionExec, end: End) {
    action.result = end.failure == null
    end.failure?.let { action.setFailureReason(if (it.error.isEmpty()) null else ASSyntax.parseLiteral(it.error), it.message) }
}

/** Returns the failure of [action], which has ended; null if it succeeded. */
internal fun failureOf(action: ActionExec): CallFailure? =
    if (action.result) null else CallFailure(action.failureReason?.let(Literal::toString).orEmpty(), action.failureMsg.orEmpty())

internal class RecordedFailure(failure: CallFailure) : CommandFailure {
    override val error = failure.error
    override val cause = failure.message
}

/** An action with an outcome that goes to [ended] and not to Jason's queue. */
internal class KeptAction(action: ActionExec, private val ended: (ActionExec) -> Unit) : ActionExec(action.actionTerm, action.intention) {
    /** Jason calls this function when the action has an outcome. The result null makes Jason ignore the outcome. */
    override fun getIntention() = null.also { ended(this) }
}

/** Returns the texts of those arguments of [call] that have variables, by their indexes. [un] contains the variables' values. */
internal fun bound(call: InternalCall, un: Unifier = call.un): Map<Int, String> {
    if (call.args.all { it.isGround }) return emptyMap() // most calls end here
    return buildMap { call.args.forEachIndexed { place, argument -> if (!argument.isGround) put(place, textOf(argument.capply(un))) } }
}

internal fun evaluationFailure(failed: Exception) = CallFailure(if (failed is NoValueException) NO_VALUE else "", failed.message.orEmpty())

internal fun evaluationFailed(failure: CallFailure): Exception =
    if (failure.error == NO_VALUE) NoValueException(failure.message) else JasonException(failure.message)

private const val NO_VALUE = "no_value"

/** Returns the annotations that [failed] gives the plan that it makes fail, without the message. */
internal fun errorsOf(failed: JasonException): List<String> =
    failed.errorTerms.filterNot { it is Structure && it.functor == "error_msg" }.map(::textOf)

/** Returns the exception with which sending this mail failed; null if it was sent. Without annotations, it has Jason's usual error. */
internal fun Mail.exception(): JasonException? {
    if (failure == null) return null
    val terms = errors.map { termOf(it) }
    val error = terms.firstOrNull() as? Structure
    if (error?.functor != "error" || error.arity != 1) return JasonException(failure)
    return JasonException(failure, error.getTerm(0)).apply { terms.drop(1).forEach(::addErrorAnnot) }
}

internal fun callFailure(failed: JasonException) = CallFailure(
    (failed.errorTerms.firstOrNull() as? Structure)?.terms?.firstOrNull()?.let(::textOf).orEmpty(), failed.message.orEmpty(),
)
