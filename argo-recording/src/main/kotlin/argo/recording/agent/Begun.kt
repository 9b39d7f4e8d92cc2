package argo.recording.agent

import argo.boundary.InternalCall
import argo.observing.CommandFailure
import argo.recording.CallFailure
import argo.recording.End
import jason.JasonException
import jason.NoValueException
import jason.asSemantics.ActionExec
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Structure

/** What an agent has begun outside of its thread and what has not ended yet. Belongs to the agent's thread. */
internal class Begun {
    private val open = HashMap<Int, (End) -> Unit>()

    /** How many things it has begun. */
    var last = 0
        private set

    /** The numbers of what has not ended yet. */
    val numbers: Set<Int> get() = open.keys

    /** It had begun [last] things, of which [open] have not ended yet. */
    fun restore(last: Int, open: Map<Int, (End) -> Unit>) {
        this.last = last
        this.open.putAll(open)
    }

    /** The agent begins something; [complete] is for its end. Returns its number. */
    fun begin(complete: (End) -> Unit): Int = (++last).also { open[it] = complete }

    /** Carries [end] out; false if it is not of something that has begun. */
    fun carryOut(end: End): Boolean = open.remove(end.number)?.let { it(end) } != null
}

/** Puts [end], the environment's, into [action]. */
internal fun complete(action: ActionExec, end: End) {
    action.result = end.failure == null
    end.failure?.let { action.setFailureReason(if (it.error.isEmpty()) null else ASSyntax.parseLiteral(it.error), it.message) }
}

/** How [action] ended. */
internal fun failureOf(action: ActionExec): CallFailure? =
    if (action.result) null else CallFailure(action.failureReason?.let(Literal::toString).orEmpty(), action.failureMsg.orEmpty())

/** A failure as it was recorded. */
internal class RecordedFailure(failure: CallFailure) : CommandFailure {
    override val error = failure.error
    override val cause = failure.message
}

/** An action whose outcome goes to [ended], and not into Jason's queue. */
internal class KeptAction(action: ActionExec, private val ended: (ActionExec) -> Unit) : ActionExec(action.actionTerm, action.intention) {
    /** Jason asks whoever hands it an outcome; without an intention it forgets it. */
    override fun getIntention() = null.also { ended(this) }
}

/** The texts of those arguments of [call] that had variables, as they are bound now, by their places. */
internal fun bound(call: InternalCall, un: Unifier = call.un): Map<Int, String> {
    if (call.args.all { it.isGround }) return emptyMap() // as of most calls
    return buildMap { call.args.forEachIndexed { place, argument -> if (!argument.isGround) put(place, textOf(argument.capply(un))) } }
}

/** Why a function has no value. */
internal fun evaluationFailure(failed: Exception) = CallFailure(if (failed is NoValueException) NO_VALUE else "", failed.message.orEmpty())

/** What was thrown where a function has no value. */
internal fun evaluationFailed(failure: CallFailure): Exception =
    if (failure.error == NO_VALUE) NoValueException(failure.message) else JasonException(failure.message)

private const val NO_VALUE = "no_value"

/** How a call failed that threw [failed]. */
internal fun callFailure(failed: JasonException) = CallFailure(
    (failed.errorTerms.firstOrNull() as? Structure)?.terms?.firstOrNull()?.let(::textOf).orEmpty(), failed.message.orEmpty(),
)
