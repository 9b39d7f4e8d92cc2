package argo.recording.agent

import argo.boundary.Boundary
import argo.observing.CommandFailure
import argo.recording.CallFailure
import jason.JasonException
import jason.asSemantics.ConcurrentInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSyntax.ASSyntax
import java.util.concurrent.atomic.AtomicBoolean

/**
 * An infrastructure's version of one of Jason's internal actions. The action's class directly extends Jason's class, and has a constructor
 * without arguments. A recording has the action's calls under Jason's name for the action. With [AwaitedOutside], the action's intention
 * may wait for other computers.
 */
interface OfInfrastructure

/** Lets internal actions that are [OfInfrastructure] wait for something outside of the agent, such as another computer's answer. */
object AwaitedOutside {
    /** The error of a message to an agent that does not exist. Plans may also match Jason's own name for this error. */
    const val NO_AGENT = "no_agent"
    private const val NO_RECEIVER = "receiver_not_found"

    /**
     * Suspends the intention of the internal action that is being carried out. Call this function on the thread of the agent of [ts]. If
     * the action itself has suspended the intention, as a question does, the returned function ends the wait only with a failure.
     *
     * @return a function that ends the wait, on any thread. If its argument is null, the intention continues. If its argument is an
     * exception, the plan fails. Only the first call of the function counts. A recording of the agent contains the end of the wait
     */
    fun begin(ts: TransitionSystem): (JasonException?) -> Unit {
        val question = ts.c.pendingIntentions.entries.find { it.value === ts.c.selectedIntention }?.key
        val key = question ?: Suspension.suspendInt(ts, "outside", 0)
        val complete = { failure: CommandFailure?, _: String? ->
            if (failure != null) ConcurrentInternalAction.resume(ts, key, true, exceptionOf(failure).errorTerms)
            else if (question == null) Suspension.resumeInt(ts, key)
        }
        val end = (Keeper.current as? Boundary)?.suspended(complete) ?: complete
        val hasEnded = AtomicBoolean()
        return { failed -> if (!hasEnded.getAndSet(true)) end(failed?.let { RecordedFailure(callFailure(it)) }, null) }
    }

    /** Returns the exception that fails a plan with the annotation `error(…)` around [error], and with the text [message] for the user. */
    fun exceptionOf(error: String, message: String): JasonException {
        val failed = JasonException(message, if (error.isEmpty()) null else termOf(error))
        if (error == NO_AGENT) failed.addErrorAnnot(ASSyntax.createStructure("error", ASSyntax.createAtom(NO_RECEIVER)))
        return failed
    }

    private fun exceptionOf(failure: CommandFailure) = exceptionOf(failure.error, failure.cause)

    /** Gives access to Jason's functions that suspend an intention. */
    private object Suspension : ConcurrentInternalAction() {
        override fun timeout(ts: TransitionSystem, intentionKey: String) = failInt(ts, intentionKey)
    }
}

internal fun CallFailure.exception(): Exception =
    if (error == THROWN) Thrown(message) else AwaitedOutside.exceptionOf(error, message)

/** Returns the failure of an action that has thrown [broken], which is no exception of Jason's. */
internal fun thrownFailure(broken: Exception) = CallFailure(THROWN, "${broken.message}")

/** A recorded exception that is no exception of Jason's. Jason logs it. A stack trace would be that of the replay. */
private class Thrown(message: String) : RuntimeException(message, null, false, false)

/** Marks a failure by an exception that is no exception of Jason's. No error of an action has this text, since it is no term. */
private const val THROWN = "#thrown"
