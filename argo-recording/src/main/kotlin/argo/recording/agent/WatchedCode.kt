package argo.recording.agent

import argo.boundary.InternalCall
import argo.insides.IncludeDirective
import argo.insides.Insides
import argo.platform.Plans
import jason.asSemantics.Agent
import jason.asSemantics.ArithFunction
import jason.asSemantics.InternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.ArithFunctionTerm
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.Rule
import jason.asSyntax.Structure
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import jason.asSyntax.VarTerm
import jason.stdlib.random
import java.util.Collections
import java.util.IdentityHashMap

internal enum class WatchedKind(val isOfProject: Boolean) {
    /** Jason or ARGO owns the action, which takes its results from outside of the agent. */
    OUTSIDE(false),

    /** Jason owns the action, see [Nature.SENDING]. */
    SENDING(false),

    PROJECT(true),

    /** The project owns the action. After a call of it, the intention waits for another thread. */
    SUSPENDING(true),
}

/** Decides on each call of code with results that do not follow from the program. Only for the agent's thread. */
internal interface CallWatch {
    fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any

    fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double
}

/** Reports that the program has an action or function of Jason that is not in the table [JasonActions]. The message names it. */
internal class UnknownCodeException(name: String) :
    Exception(
        "the program uses $name; this version of ARGO does not know whether that reads or changes anything outside of the agent",
    )

/**
 * Makes this object the keeper and the watch of the agent of [ts]. From now on this object gets the operations that the agent begins
 * outside of its thread, and decides on the agent's calls. Returns the agent's watched code.
 *
 * @throws UnknownCodeException if the program has code that cannot be watched; this object does not become the keeper
 */
internal fun <T> T.watch(ts: TransitionSystem): WatchedCode where T : Keeper, T : CallWatch {
    val code = WatchedCode(ts, this).apply { begin() }
    KeptTimers.install()
    IncludeDirective.install()
    KeptTasks.insertInto(ts, this)
    return code
}

/**
 * Asks [watch] about each call of an internal action or function that reads or changes anything outside of the agent. Asks about the
 * project's own code, and about the code of Jason that the table [JasonActions] lists as inputs or effects. Jason looks an action up when
 * it reads a program, so this class changes the program's own terms.
 */
internal class WatchedCode(private val ts: TransitionSystem, private val watch: CallWatch) {
    private var seen = identities() // objects that the current visit has seen
    private val actions = HashMap<String, InternalAction>()
    private var plans: List<Plan> = emptyList() // visited plans
    private var isStale = false
    private var unknown: UnknownCodeException? = null // looked-up code that cannot be watched

    val agent: Agent get() = ts.ag

    /** Watches the agent's current plans and rules, and all code that the agent looks up later. */
    fun begin() {
        visitAll()
        ts.c.events.forEach { visit(it.trigger.literal as Any) } // the program's goals; Jason evaluates their arguments later
        WatchedActions.install(ts.ag, ::found)
        WatchedFunctions.install()
    }

    /** Returns [action] in its watched form. The agent has looked up [action] by [name], for its program or for a term made from a text. */
    private fun found(name: String, action: InternalAction): InternalAction {
        if (JasonActions.isUnknown(action)) unknown = UnknownCodeException(JasonActions.nameOf(action))
        return watched(name, action)
    }

    /** Watches the [content] of a received message. The content may have code that the sender has looked up. */
    fun received(content: Any?) = try {
        visit(content)
    } catch (refused: UnknownCodeException) {
        unknown = refused
    } finally {
        seen.clear()
    }

    /**
     * Notes that the agent includes a file. Jason then looks up the actions of all plans of the agent again, even if the file has only
     * beliefs and rules.
     */
    fun included() {
        isStale = true
    }

    /**
     * Watches the plans that the agent has got from messages or included files since the last call. Jason has looked up their actions
     * again.
     *
     * @throws UnknownCodeException if the agent has code that cannot be watched
     */
    fun watchAdded() {
        unknown?.let { throw it }
        val now = Plans.of(ts.ag).all
        val isSame = now.size == plans.size && now.lastOrNull() === plans.lastOrNull() && now.firstOrNull() === plans.firstOrNull()
        if (!isSame || isStale) visitAll()
    }

    private fun visitAll() {
        plans = Plans.of(ts.ag).all.toList()
        plans.forEach(::visit)
        ts.ag.bb.forEach { visit(it as Any) } // a plan may get code from a belief
        seen = identities()
        isStale = false
    }

    /** Returns [action], which the program calls [name]. If the action must be watched, returns its watched form. */
    fun watched(name: String, action: InternalAction): InternalAction =
        if (isPlain(action)) actions.getOrPut(calledName(name, action)) { watched(name, action, watch) } else action

    fun watched(function: ArithFunction): ArithFunction = watched(function, watch)

    /**
     * Returns the program's action of the class called [type]. If the action must be watched, returns its watched form.
     *
     * @throws ReflectiveOperationException if the program has no action of this class
     */
    fun action(type: String): InternalAction = watched(type, ts.ag.getIA(type))

    /**
     * Returns the program's function [name]. If the function must be watched, returns its watched form.
     *
     * @throws IllegalArgumentException if the program has no function of this name
     */
    fun function(name: String): ArithFunction = (0..MAX_ARITY).firstNotNullOfOrNull { ts.ag.getFunction(name, it) }?.let(::watched)
        ?: throw IllegalArgumentException("there is no function $name")

    private fun visit(plan: Plan) {
        if (!seen.add(plan)) return
        plan.label?.let { visit(it as Any) }
        plan.trigger?.let { visit(it.literal as Any?) }
        plan.context?.let { visit(it as Any) }
        visit(plan.body as Any?)
        Plans.within(plan)?.all?.forEach(::visit)
    }

    private fun visit(term: Any?) {
        if (term is Plan) return visit(term)
        if (term == null || !seen.add(term)) return
        when (term) {
            is VarTerm -> return visitAnnotations(term)
            is Trigger -> return visit(term.literal as Any?)
            is Rule -> visit(term.body as Any?)
            is PlanBody -> {
                visit(term.bodyTerm as Any?)
                visit(term.bodyNext as Any?)
            }
            is InternalActionLiteral -> actionOf(term)?.let { term.setIA(watched(term.functor, it.also(::requireKnown))) }
            is ArithFunctionTerm -> function[term]?.let { function[term] = watched(it.also(::requireKnown)) }
        }
        if (term is ListTerm) term.asList.forEach { visit(it as Any?) }
        else if (term is Structure) term.terms?.forEach { visit(it as Any?) }
        if (term is Literal) visitAnnotations(term)
    }

    private fun visitAnnotations(literal: Literal) {
        if (literal.hasAnnot()) literal.annots.forEach { visit(it as Any?) }
    }

    /** Returns the action that [term] calls; null if there is none. Jason reports a missing action when the agent calls it. */
    private fun actionOf(term: InternalActionLiteral): InternalAction? = try {
        term.getIA(ts.ag)
    } catch (_: ReflectiveOperationException) {
        null
    } catch (_: LinkageError) {
        null
    } catch (_: ClassCastException) { // the class is no action
        null
    }

    private fun requireKnown(code: Any) {
        val own = if (code is Watched) code.code else code
        if (JasonActions.isUnknown(own)) throw UnknownCodeException(JasonActions.nameOf(own))
    }

    companion object {
        private const val MAX_ARITY = 9
        private val function = Insides.functionOfTerm

        private fun identities(): MutableSet<Any> = Collections.newSetFromMap(IdentityHashMap())

        /**
         * Returns [action], which the program calls [name]. If the action must be watched, returns a wrapper that asks [watch] about each
         * call.
         */
        fun watched(name: String, action: InternalAction, watch: CallWatch): InternalAction = when {
            !isPlain(action) -> action
            action is random -> WatchedRandom(action, WatchedAction(calledName(name, action), action, watch))
            else -> WatchedAction(calledName(name, action), action, watch)
        }

        fun watched(function: ArithFunction, watch: CallWatch): ArithFunction = when {
            function is WatchedFunction && function.watch === NobodyWatches -> WatchedFunction(function.code, watch)
            isPlain(function) -> WatchedFunction(function, watch)
            else -> function
        }

        private fun calledName(name: String, action: InternalAction) =
            if (JasonActions.isOwn(action.javaClass)) JasonActions.nameOf(action) else name

        /** Returns true if [code] must be replaced by a watched form. Unknown code is also replaced, so that no replay carries it out. */
        private fun isPlain(code: Any) = when {
            code is Watched -> false
            !JasonActions.isOwn(code.javaClass) || code is OfInfrastructure -> true
            else -> JasonActions.natureOf(code.javaClass)?.let(JasonActions::isRecorded) ?: JasonActions.isUnknown(code)
        }
    }
}
