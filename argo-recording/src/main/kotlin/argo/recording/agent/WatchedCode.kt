package argo.recording.agent

import argo.boundary.InternalCall
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

/** Whose an internal action is. */
internal enum class WatchedKind {
    /** Jason's or ARGO's: its results come from outside. */
    OUTSIDE,

    /** The project's. */
    PROJECT,

    /** The project's, and its intention waits for another thread. */
    SUSPENDING,
}

/** Who is asked about each call of code whose results are not in the program. Belongs to the agent's thread. */
internal interface CallWatch {
    fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any

    fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double
}

/** The program of an agent has an action or function of Jason's that is not in the table [JasonCode]; the message names it. */
internal class UnknownCodeException(name: String) :
    Exception(
        "the program uses $name, of which this version of ARGO does not know whether it reads or changes what is outside of the agent",
    )

/**
 * Keeps what the agent of [ts] begins outside of its thread, and is asked about its calls, from now on. Returns its code.
 * @throws UnknownCodeException if its program has code that cannot be watched; the agent is as it was then
 */
internal fun <T> T.watch(ts: TransitionSystem): WatchedCode where T : Keeper, T : CallWatch {
    val code = WatchedCode(ts, this).apply { begin() }
    KeptTimers.install()
    KeptInclude.install()
    KeptTasks.insertInto(ts, this)
    return code
}

/**
 * Has [watch] asked about the internal actions and functions of an agent that give what is not in its program, or change what is outside of
 * it: those of the project, and those of Jason that [JasonCode] calls inputs and effects. Jason looks an action up when it reads a program,
 * so the program's own terms are changed.
 */
internal class WatchedCode(private val ts: TransitionSystem, private val watch: CallWatch) {
    private var seen = identities() // by the visit that is under way
    private val actions = HashMap<String, InternalAction>()
    private var plans: List<Plan> = emptyList() // those that have been visited
    private var isStale = false
    private var unknown: UnknownCodeException? = null // what it has looked up since

    /** The agent whose code it is. */
    val agent: Agent get() = ts.ag

    /** Watches all plans and rules that the agent has now, and what it looks up later. */
    fun begin() {
        visitAll()
        ts.c.events.forEach { visit(it.trigger.literal as Any) } // goals of the program, whose arguments are evaluated later
        WatchedActions.install(ts.ag, ::found)
        WatchedFunctions.install()
    }

    /** The agent has looked [action] up, which the program calls [name]: as its program has it, or a term that it has made of a text. */
    private fun found(name: String, action: InternalAction): InternalAction {
        if (JasonCode.isUnknown(action)) unknown = UnknownCodeException(JasonCode.nameOf(action))
        return watched(name, action)
    }

    /** Watches what the agent gets in a message: the sender may have looked its code up. */
    fun received(content: Any?) = try {
        visit(content)
    } catch (refused: UnknownCodeException) {
        unknown = refused
    } finally {
        seen.clear()
    }

    /** The agent includes a file: Jason looks the actions of all its plans up anew, also where the file has beliefs and rules only. */
    fun included() {
        isStale = true
    }

    /**
     * Watches what the agent has been told or has included since: Jason looks its actions up anew.
     * @throws UnknownCodeException if it has code that cannot be watched
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
        ts.ag.bb.forEach { visit(it as Any) } // a belief may hold code, which a plan takes out of it
        seen = identities()
        isStale = false
    }

    /** [action], which the program calls [name], watched if it is to be. */
    fun watched(name: String, action: InternalAction): InternalAction =
        if (isPlain(action)) actions.getOrPut(calledName(name, action)) { watched(name, action, watch) } else action

    /** [function], watched if it is to be. */
    fun watched(function: ArithFunction): ArithFunction = watched(function, watch)

    /**
     * The action of the program whose class is called [type], as [watched] has it.
     * @throws ReflectiveOperationException if there is none
     */
    fun action(type: String): InternalAction = watched(type, ts.ag.getIA(type))

    /**
     * The function [name] of the program, as [watched] has it.
     * @throws IllegalArgumentException if it has none
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

    /** The action that [term] calls; null: there is none, of which Jason tells when it is called. */
    private fun actionOf(term: InternalActionLiteral): InternalAction? = try {
        term.getIA(ts.ag)
    } catch (_: ReflectiveOperationException) {
        null
    } catch (_: LinkageError) {
        null
    } catch (_: ClassCastException) { // of a class that is no action
        null
    }

    private fun requireKnown(code: Any) {
        val own = if (code is Watched) code.code else code
        if (JasonCode.isUnknown(own)) throw UnknownCodeException(JasonCode.nameOf(own))
    }

    companion object {
        private const val MAX_ARITY = 9
        private val function = Insides.functionOfTerm

        private fun identities(): MutableSet<Any> = Collections.newSetFromMap(IdentityHashMap())

        /** [action], which the program calls [name]; if it is to be watched [watch] is asked about its calls. */
        fun watched(name: String, action: InternalAction, watch: CallWatch): InternalAction = when {
            !isPlain(action) -> action
            action is random -> WatchedRandom(action, WatchedAction(calledName(name, action), action, watch))
            else -> WatchedAction(calledName(name, action), action, watch)
        }

        /** [function]; if it is to be watched [watch] is asked about it. */
        fun watched(function: ArithFunction, watch: CallWatch): ArithFunction = when {
            function is WatchedFunction && function.watch === NobodyWatches -> WatchedFunction(function.code, watch)
            isPlain(function) -> WatchedFunction(function, watch)
            else -> function
        }

        private fun calledName(name: String, action: InternalAction) =
            if (JasonCode.isOwn(action.javaClass)) JasonCode.nameOf(action) else name

        /** Returns true if [code] is to be watched and is not yet. What is not known is, too, so that no replay carries it out. */
        private fun isPlain(code: Any) = when {
            code is Watched -> false
            !JasonCode.isOwn(code.javaClass) -> true
            else -> JasonCode.natureOf(code.javaClass.name)?.let(JasonCode::isRecorded) ?: JasonCode.isUnknown(code)
        }
    }
}
