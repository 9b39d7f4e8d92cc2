package argo.recording.agent

import argo.boundary.InternalCall
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
import jason.asSyntax.VarTerm
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

/** Keeps what the agent of [ts] begins outside of its thread, and is asked about its calls, from now on. Returns its code. */
internal fun <T> T.watch(ts: TransitionSystem): WatchedCode where T : Keeper, T : CallWatch {
    KeptTimers.install()
    KeptTasks.insertInto(ts, this)
    return WatchedCode(ts, this).apply { begin() }
}

/**
 * Has [watch] asked about the internal actions and functions of an agent that give what is not in its program: those of the project, and
 * those of Jason that read a clock, draw a number or ask the infrastructure. Jason looks an action up when it reads a program, so the
 * program's own terms are changed.
 */
internal class WatchedCode(private val ts: TransitionSystem, private val watch: CallWatch) {
    private val seen: MutableSet<Any> = Collections.newSetFromMap(IdentityHashMap())
    private val actions = HashMap<String, InternalAction>()
    private val functionOf = ArithFunctionTerm::class.java.getDeclaredField("function").apply { isAccessible = true }

    private var plans = 0
    private var lastPlan: Plan? = null

    /** The agent whose code it is. */
    val agent: Agent get() = ts.ag

    /** Watches all plans and rules that the agent has now, and actions that it looks up later. */
    fun begin() {
        visitAll()
        ts.c.events.forEach { visit(it.trigger.literal as Any) } // goals of the program, whose arguments are evaluated later
        INPUTS.filter { it != RANDOM }.forEach { name -> ts.ag.setIA("jason.stdlib$name", watched(name, ts.ag.getIA(name))) }
    }

    /** Watches what the agent has been told or has included since: Jason looks its actions up anew. */
    fun visitNew() {
        val now = Plans.of(ts.ag).all
        if (now.size == plans && now.lastOrNull() === lastPlan) return
        seen.clear()
        visitAll()
    }

    private fun visitAll() {
        val all = Plans.of(ts.ag).all
        plans = all.size
        lastPlan = all.lastOrNull()
        all.forEach(::visit)
        ts.ag.bb.filterIsInstance<Rule>().forEach { visit(it.body) }
    }

    /** The action [name] of the program, watched. */
    fun watchedAction(name: String): InternalAction = actions.getOrPut(name) {
        val action = ts.ag.getIA(name)
        action as? WatchedAction ?: WatchedAction(name, action, isOfProject(action), watch)
    }

    /** The function [name] of the program, watched. */
    fun watchedFunction(name: String): ArithFunction =
        function(name).let { it as? WatchedFunction ?: WatchedFunction(it, isOfProject(it), watch) }

    /**
     * The function [name] of the program.
     * @throws IllegalArgumentException if it has none
     */
    fun function(name: String): ArithFunction = (0..MAX_ARITY).firstNotNullOfOrNull { ts.ag.getFunction(name, it) }
        ?: throw IllegalArgumentException("there is no function $name")

    private fun visit(plan: Plan) {
        if (!seen.add(plan)) return
        plan.context?.let { visit(it as Any) }
        visit(plan.body as Any?)
        Plans.within(plan)?.all?.forEach(::visit)
    }

    private fun visit(term: Any?) {
        if (term == null || term is VarTerm || !seen.add(term)) return
        when (term) {
            is Plan -> return visit(term)
            is PlanBody -> {
                visit(term.bodyTerm as Any?)
                visit(term.bodyNext as Any?)
            }
            is InternalActionLiteral -> term.getIA(ts.ag).let { action -> watchedOrNull(term.functor, action)?.let(term::setIA) }
            is ArithFunctionTerm -> (functionOf.get(term) as? ArithFunction)?.let { watchedOrNull(it) }?.let { functionOf.set(term, it) }
        }
        if (term is ListTerm) term.asList.forEach { visit(it as Any?) }
        else if (term is Structure) term.terms?.forEach { visit(it as Any?) }
        if (term is Literal && term.hasAnnot()) term.annots.forEach { visit(it as Any?) }
    }

    private fun watchedOrNull(name: String, action: InternalAction): InternalAction? =
        if (action is WatchedAction || name !in INPUTS && !isOfProject(action)) null else watched(name, action)

    private fun watched(name: String, action: InternalAction) =
        actions.getOrPut(name) { WatchedAction(name, action, isOfProject(action), watch) }

    private fun watchedOrNull(of: ArithFunction): ArithFunction? =
        if (of is WatchedFunction || of.name !in FUNCTIONS && !isOfProject(of)) null else WatchedFunction(of, isOfProject(of), watch)

    private fun isOfProject(code: Any) = code.javaClass.packageName.let { it != "argo" && !it.startsWith("jason.") }

    private class WatchedAction(
        val name: String,
        private val action: InternalAction,
        private val isOfProject: Boolean,
        private val watch: CallWatch,
    ) : InternalAction by action {
        override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
            current(watch).call(InternalCall(name, args, un), kind()) { action.execute(ts, it, args) }

        private fun kind() = when {
            !isOfProject -> WatchedKind.OUTSIDE
            action.suspendIntention() -> WatchedKind.SUSPENDING
            else -> WatchedKind.PROJECT
        }
    }

    private class WatchedFunction(private val function: ArithFunction, private val isOfProject: Boolean, private val watch: CallWatch) :
        ArithFunction by function {
        override fun evaluate(ts: TransitionSystem?, args: Array<Term>): Double =
            current(watch).evaluate(function.name, args, isOfProject) { function.evaluate(ts, args) }
    }

    companion object {
        /** The name that the program has for [code], an action or a function that is watched; null: it is not. */
        fun nameOf(code: Any): String? = (code as? WatchedAction)?.name ?: (code as? WatchedFunction)?.name

        /** Who watches the agent that calls: a plan that one agent tells another comes with the code of the first. */
        private fun current(own: CallWatch) = Keeper.current as? CallWatch ?: own

        private const val MAX_ARITY = 9
        private const val RANDOM = ".random"

        /** Jason's actions whose results come from chance, a clock, the infrastructure or the disk. */
        private val INPUTS = setOf(
            RANDOM, ".shuffle", ".time", ".date", ".nano_time", ".all_names", ".create_agent", ".kill_agent", ".stopMAS",
            ".df_search", ".df_register", ".df_deregister", ".df_subscribe", ".list_files",
        )
        private val FUNCTIONS = setOf("math.random", "system.time")
    }
}
