package argo

import argo.acting.termOf
import argo.boundary.Boundary
import argo.boundary.InternalCall
import argo.boundary.Live
import argo.calls.ArgumentException
import argo.calls.Failure
import argo.calls.NO_ANSWER
import argo.calls.wrongArgument
import argo.filters.jason.PerceptSyntaxException
import argo.observing.CommandFailure
import jason.JasonException
import jason.architecture.AgArch
import jason.asSemantics.ConcurrentInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Term
import java.io.Serializable

/**
 * The base of ARGO's internal actions. Finds the calling agent, and makes plans fail. An action does its work at once, or suspends the
 * intention until another thread has done the work. The action never suspends the agent.
 */
abstract class BoardInternalAction internal constructor(
    @Transient private val name: String,
    @Transient private val arguments: IntRange,
) : ConcurrentInternalAction(), Serializable {
    /** Returns true if the action suspends its intention until the work has ended: see [Call.suspendIntention]. */
    final override fun suspendIntention(): Boolean = suspends

    internal open val suspends: Boolean get() = false

    /** Returns the term in [args] with which a robot's answer must unify; null if no answer is awaited. */
    internal open fun awaitedIn(args: Array<Term>): Term? = null

    /** Does the action's work. Called by the agent's thread. */
    internal abstract fun run(call: Call)

    final override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        val call = Call(ts, args)
        val suspend: (() -> Unit)? = if (suspends) ({ call.suspendIntention() }) else null
        return ts.boundary.call(InternalCall(name, args, un, suspend)) { carryOut(call) }
    }

    /** Carries out [call] for a caller outside of any intention. Throws [JasonException] if it fails. Called by the agent's thread. */
    internal fun carryOut(call: Call): Boolean {
        try {
            if (call.args.size !in arguments) throw ArgumentException("it takes ${counted(arguments)}, not ${call.args.size}")
            run(call)
        } catch (refused: ArgumentException) {
            throw wrongArgument(refused.message.orEmpty()).of(call.text)
        }
        return true
    }

    /** Actions set no timeout, so Jason never calls this function. The links for which an action waits have their own time limits. */
    final override fun timeout(ts: TransitionSystem, intentionKey: String) = failInt(ts, intentionKey)

    /** Java's serialization calls this function when it has read an agent, and uses the returned action instead of the read one. */
    protected fun readResolve(): Any = javaClass.getConstructor().newInstance()

    internal inner class Call(val ts: TransitionSystem, val args: Array<Term>) {
        val text: String get() = "$name(${args.joinToString(",")})"

        val arch: Arch
            get() = archOf(ts) ?: throw notArgo(ts).of(text)

        fun failure(error: String, cause: String): JasonException = Failure(error, cause).of(text)

        /**
         * Suspends the intention. The returned function resumes the intention. Call the function once, on any thread. Its arguments are the
         * failure of the plan, or null, and the text of the answer, or null. If the agent drops the intention before this call, the agent's
         * thread later calls [giveUp].
         */
        fun suspendIntention(giveUp: (() -> Unit)? = null): (Failure?, String?) -> Unit {
            val key = suspendInt(ts, name, 0)
            val awaited = awaitedIn(args)
            if (giveUp != null) arch.awaited.begin(key, giveUp)
            return ts.boundary.suspended { failure, answer ->
                arch.awaited.end(key)
                if (failure != null || awaited == null) end(key, failure)
                else ts.runAtBeginOfNextCycle { end(key, differing(key, awaited, answer)) }
                arch.wake { !ts.c.pendingIntentions.containsKey(key) }
            }
        }

        private fun end(key: String, failure: CommandFailure?) =
            resume(ts, key, failure != null, failure?.let { Failure(it.error, it.cause).of(text).errorTerms })

        /** Unifies [awaited] with [answer] in the intention suspended under [key]. Returns null if they unify, else the failure. */
        private fun differing(key: String, awaited: Term, answer: String?): Failure? {
            if (answer == null) return Failure(NO_ANSWER, "no answer to it is known")
            val intention = ts.c.pendingIntentions[key] ?: return null // the agent has dropped the intention
            val term = try {
                termOf(answer)
            } catch (unreadable: PerceptSyntaxException) {
                return Failure(NO_ANSWER, "it was carried out, but its answer cannot be read: ${unreadable.message}")
            }
            val isAlike = intention.peek().unif.unifies(awaited, term)
            return if (isAlike) null else Failure("other_answer", "it was carried out, and the answer $answer does not unify with $awaited")
        }
    }
}

private fun counted(arguments: IntRange) = when {
    arguments.first == arguments.last -> if (arguments.first == 1) "one argument" else "${arguments.first} arguments"
    else -> "${arguments.first} to ${arguments.last} arguments"
}

internal fun architectures(ts: TransitionSystem): Sequence<AgArch> = generateSequence(ts.agArch) { it.nextAgArch }

/** Returns the [Arch] of the agent of [ts]; null if the agent has none. */
internal fun archOf(ts: TransitionSystem): Arch? = ts.agArch as? Arch ?: architectures(ts).filterIsInstance<Arch>().firstOrNull()

internal val TransitionSystem.boundary: Boundary get() = archOf(this)?.boundary ?: Live

internal fun notArgo(ts: TransitionSystem) =
    Failure("not_argo", "agent ${ts.agArch.agName} has no board: declare it with \"agentArchClass argo.Arch\" in the .mas2j")
