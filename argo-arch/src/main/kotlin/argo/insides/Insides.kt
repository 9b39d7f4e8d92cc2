package argo.insides

import jason.architecture.AgArch
import jason.asSemantics.Agent
import jason.asSemantics.ArithFunction
import jason.asSemantics.Circumstance
import jason.asSemantics.ConcurrentInternalAction
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSemantics.InternalAction
import jason.asSemantics.Message
import jason.asSemantics.Option
import jason.asSemantics.TransitionSystem
import jason.asSyntax.ArithFunctionTerm
import jason.asSyntax.Literal
import jason.asSyntax.UnnamedVar
import jason.asSyntax.directives.Directive
import jason.asSyntax.directives.DirectiveProcessor
import jason.asSyntax.directives.FunctionRegister
import jason.bb.DefaultBeliefBase
import jason.stdlib.at
import jason.util.RunnableSerializable
import java.util.Queue
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.atomic.AtomicInteger

/**
 * All private members of Jason that ARGO uses, except those in [WaitEvents]. A member's comment says why Jason's public members do not
 * suffice. Only ARGO's own modules may use the members, since another version of Jason may have other members.
 */
object Insides {
    private val found = ArrayList<Inside<*>>()

    /** Jason publishes the scheduler of `.wait` and `.at`, but nobody can replace it. */
    val scheduler: Inside<ScheduledExecutorService> = of(Agent::class.java, "scheduler")

    /** `setIA` sets one action under a known name. A term that is read from a text may need an action of any name. */
    val actions: Inside<Map<String, InternalAction>> = of(Agent::class.java, "internalActions")

    /** `addFunction` refuses a name that already exists, such as `math.random`. */
    val functions: Inside<MutableMap<String, ArithFunction>> = of(FunctionRegister::class.java, "functions")

    /** A term gets its function when it is made; there is no setter. */
    val functionOfTerm: Inside<ArithFunction?> = of(ArithFunctionTerm::class.java, "function")

    /** `registerDirective` does not replace a directive that has been used. The `include` that it makes would have no source path. */
    val directives: Inside<MutableMap<String, Directive>> = of(DirectiveProcessor::class.java, "singletons")

    /** `getDirective` logs an error for a name that is no directive. */
    val directiveClasses: Inside<Map<String, Class<*>>> = of(DirectiveProcessor::class.java, "directives")

    /** `runAtBeginOfNextCycle` tells nobody that another thread has added work. */
    val tasks: Inside<Queue<RunnableSerializable>> = of(TransitionSystem::class.java, "taskForBeginOfCycle")

    /** The number of cycles since the agent last perceived (`nrcbp`). Jason does not publish it. */
    val cyclesUnperceived: Inside<Int> = of(TransitionSystem::class.java, "nrcslbr")

    /** `insertAgArch` sets these two fields, but also changes the agent. A serialized agent must stay unchanged. */
    val nextArch: Inside<AgArch?> = of(AgArch::class.java, "successor")
    val firstArch: Inside<AgArch> = of(AgArch::class.java, "firstArch")

    /** True if Jason has notified the agent that it falls asleep. No public member shows this. */
    val isAsleep: Inside<Boolean> = of(TransitionSystem::class.java, "sleepingEvt")

    /** Jason does not publish which rule of its cycle comes next. */
    val nextDeliberating: Inside<TransitionSystem.State> = of(TransitionSystem::class.java, "stepDeliberate")
    val nextActing: Inside<TransitionSystem.State> = of(TransitionSystem::class.java, "stepAct")

    // For a replay that begins in the middle of a recording. Jason makes these events and intentions only by reasoning.

    /** There is no setter. */
    val atomicEvent: Inside<Event?> = of(Circumstance::class.java, "AE")

    /** The public getter also removes the intention. */
    val atomicIntention: Inside<Intention?> = of(Circumstance::class.java, "AI")

    /** There is no setter. */
    val isAtomicSuspended: Inside<Boolean> = of(Circumstance::class.java, "atomicIntSuspended")

    /** The number of intentions with a goal condition. Jason only shows whether there are any. */
    val goalConditions: Inside<Int> = of(Circumstance::class.java, "intentionsWithGoalCondition")

    /** There is no setter. */
    val selectedEvent: Inside<Event?> = of(Circumstance::class.java, "SE")

    /** There is no setter. */
    val selectedOption: Inside<Option?> = of(Circumstance::class.java, "SO")

    /** There is no setter. */
    val selectedIntention: Inside<Intention?> = of(Circumstance::class.java, "SI")

    /** The order of percepts depends on the capacity of this set. Public methods add beliefs one by one, and cannot set the capacity. */
    val percepts: Inside<Set<Literal>> = of(DefaultBeliefBase::class.java, "percepts")

    /** Jason's counters, which all agents of a program share. No public member reads or sets their values. */
    val intentionCounter: Inside<AtomicInteger> = of(Intention::class.java, "idCount")
    val messageCounter: Inside<AtomicInteger> = of(Message::class.java, "idCount")
    val planCounter: Inside<AtomicInteger> = of(Agent::class.java.getMethod("getPL").returnType, "lastPlanLabel")
    val variableCounter: Inside<AtomicInteger> = of(UnnamedVar::class.java, "varCont")
    val callCounter: Inside<AtomicInteger> = of(ConcurrentInternalAction::class.java, "actcount", "actCount") // 3.2.1, 3.3.0
    val atCounter: Inside<AtomicInteger> = of(at::class.java, "idCount")

    /** All fields above, and the fields of `.wait`. */
    val all: List<Inside<*>> get() = found + WaitEvents.fields

    private fun <T> of(owner: Class<*>, vararg names: String): Inside<T> = Inside<T>({ owner }, *names).also { found += it }

    /**
     * Returns true if the agent of [ts] has deliberated in this cycle, but has not yet selected an intention. Only for the agent's thread,
     * between two rules of its cycle.
     */
    fun isBeforeIntention(ts: TransitionSystem): Boolean =
        nextActing[ts] == TransitionSystem.State.SelInt && nextDeliberating[ts] == TransitionSystem.State.ProcAct
}
