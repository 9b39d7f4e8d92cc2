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
 * All private members of Jason that ARGO uses, except those of `.wait`, which [WaitEvents] has. A member's comment says why no extension
 * point of Jason suffices. Only ARGO's own modules may use the members: another version of Jason may have others.
 */
object Insides {
    private val found = ArrayList<Inside<*>>()

    /** Jason lets others use the scheduler of `.wait` and `.at`, but not replace it. */
    val scheduler: Inside<ScheduledExecutorService> = of(Agent::class.java, "scheduler")

    /** `setIA` sets one action of a known name, but a term made from a text may ask for any name. */
    val actions: Inside<Map<String, InternalAction>> = of(Agent::class.java, "internalActions")

    /** `addFunction` refuses a name that exists already, such as `math.random`. */
    val functions: Inside<MutableMap<String, ArithFunction>> = of(FunctionRegister::class.java, "functions")

    /** A term gets its function when it is made; there is no setter. */
    val functionOfTerm: Inside<ArithFunction?> = of(ArithFunctionTerm::class.java, "function")

    /** `registerDirective` does not replace a used directive, and would make a new `include` without the source path. */
    val directives: Inside<MutableMap<String, Directive>> = of(DirectiveProcessor::class.java, "singletons")

    /** `getDirective` logs an error for a name that is none. */
    val directiveClasses: Inside<Map<String, Class<*>>> = of(DirectiveProcessor::class.java, "directives")

    /** If another thread leaves work, `runAtBeginOfNextCycle` notifies nobody. */
    val tasks: Inside<Queue<RunnableSerializable>> = of(TransitionSystem::class.java, "taskForBeginOfCycle")

    /** The cycles since the agent last perceived (`nrcbp`): Jason counts them without publishing the number. */
    val cyclesUnperceived: Inside<Int> = of(TransitionSystem::class.java, "nrcslbr")

    /** `insertAgArch` sets these, and puts an architecture into the agent at once; one in a serialized copy must leave the agent alone. */
    val nextArch: Inside<AgArch?> = of(AgArch::class.java, "successor")
    val firstArch: Inside<AgArch> = of(AgArch::class.java, "firstArch")

    /** True if Jason has notified the agent that it falls asleep; no public member shows this. */
    val isAsleep: Inside<Boolean> = of(TransitionSystem::class.java, "sleepingEvt")

    /** Jason tells nobody which of its rules comes next. */
    val nextDeliberating: Inside<TransitionSystem.State> = of(TransitionSystem::class.java, "stepDeliberate")
    val nextActing: Inside<TransitionSystem.State> = of(TransitionSystem::class.java, "stepAct")

    // Events and intentions of an agent whose replay begins in the middle of its life: Jason makes such objects only by reasoning

    /** There is no setter. */
    val atomicEvent: Inside<Event?> = of(Circumstance::class.java, "AE")

    /** The public getter also removes the intention. */
    val atomicIntention: Inside<Intention?> = of(Circumstance::class.java, "AI")

    /** There is no setter. */
    val isAtomicSuspended: Inside<Boolean> = of(Circumstance::class.java, "atomicIntSuspended")

    /** Jason counts these intentions, and shows only whether there are any. */
    val goalConditions: Inside<Int> = of(Circumstance::class.java, "intentionsWithGoalCondition")

    /** There is no setter. */
    val selectedEvent: Inside<Event?> = of(Circumstance::class.java, "SE")

    /** There is no setter. */
    val selectedOption: Inside<Option?> = of(Circumstance::class.java, "SO")

    /** There is no setter. */
    val selectedIntention: Inside<Intention?> = of(Circumstance::class.java, "SI")

    /** The order of percepts depends on the capacity of this set. Public methods add beliefs one by one, and cannot set the capacity. */
    val percepts: Inside<Set<Literal>> = of(DefaultBeliefBase::class.java, "percepts")

    /** Jason's counters, shared by all agents of a program: Jason neither shows nor sets their values. */
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
     * Returns true if the agent of [ts] has deliberated, but has chosen no intention yet in this cycle. Only for the agent's thread,
     * between two rules of its cycle.
     */
    fun isBeforeIntention(ts: TransitionSystem): Boolean =
        nextActing[ts] == TransitionSystem.State.SelInt && nextDeliberating[ts] == TransitionSystem.State.ProcAct
}
