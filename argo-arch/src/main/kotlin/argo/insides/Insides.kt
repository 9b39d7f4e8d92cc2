package argo.insides

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
 * All private members of Jason that ARGO reaches, and beside each why no extension point does. They are for ARGO's own modules: another
 * version of Jason may have others. Where the members of `.wait` are, see [WaitEvents].
 */
object Insides {
    private val found = ArrayList<Inside<*>>()

    /** Jason gives its scheduler, for `.wait` and `.at`, and takes none. */
    val scheduler: Inside<ScheduledExecutorService> = of(Agent::class.java, "scheduler")

    /** `setIA` wants each name before it is used; a term made of a text asks for any. */
    val actions: Inside<Map<String, InternalAction>> = of(Agent::class.java, "internalActions")

    /** `addFunction` refuses a name that there is, as that of `math.random`. */
    val functions: Inside<MutableMap<String, ArithFunction>> = of(FunctionRegister::class.java, "functions")

    /** A term gets its function when it is made, and shows it to nobody who could wrap it. */
    val functionOfTerm: Inside<ArithFunction?> = of(ArithFunctionTerm::class.java, "function")

    /** `registerDirective` changes no directive that has been used; and it would make another `include`, without the source path. */
    val directives: Inside<MutableMap<String, Directive>> = of(DirectiveProcessor::class.java, "singletons")

    /** `runAtBeginOfNextCycle` tells nobody that another thread has left work. */
    val tasks: Inside<Queue<RunnableSerializable>> = of(TransitionSystem::class.java, "taskForBeginOfCycle")

    /** How many cycles the agent has not perceived (`nrcbp`): only Jason counts. */
    val cyclesUnperceived: Inside<Int> = of(TransitionSystem::class.java, "nrcslbr")

    /** Whether the agent has been told that it falls asleep: nothing shows it. */
    val isAsleep: Inside<Boolean> = of(TransitionSystem::class.java, "sleepingEvt")

    // what an agent that begins in the middle of its life has in mind: Jason makes it by reasoning only

    /** There is no setter. */
    val atomicEvent: Inside<Event?> = of(Circumstance::class.java, "AE")

    /** It can be had by removing it only. */
    val atomicIntention: Inside<Intention?> = of(Circumstance::class.java, "AI")

    /** There is no setter. */
    val isAtomicSuspended: Inside<Boolean> = of(Circumstance::class.java, "atomicIntSuspended")

    /** Only Jason counts them, and shows whether there are any. */
    val goalConditions: Inside<Int> = of(Circumstance::class.java, "intentionsWithGoalCondition")

    /** There is no setter. */
    val selectedEvent: Inside<Event?> = of(Circumstance::class.java, "SE")

    /** There is no setter. */
    val selectedOption: Inside<Option?> = of(Circumstance::class.java, "SO")

    /** There is no setter. */
    val selectedIntention: Inside<Intention?> = of(Circumstance::class.java, "SI")

    /** The order of percepts follows from the size of this set; beliefs are added one by one. */
    val percepts: Inside<Set<Literal>> = of(DefaultBeliefBase::class.java, "percepts")

    /** Jason's counters, which all agents of a program share: they are drawn from, and neither shown nor set. */
    val intentionCounter: Inside<AtomicInteger> = of(Intention::class.java, "idCount")
    val messageCounter: Inside<AtomicInteger> = of(Message::class.java, "idCount")
    val planCounter: Inside<AtomicInteger> = of(Agent::class.java.getMethod("getPL").returnType, "lastPlanLabel")
    val variableCounter: Inside<AtomicInteger> = of(UnnamedVar::class.java, "varCont")
    val callCounter: Inside<AtomicInteger> = of(ConcurrentInternalAction::class.java, "actcount", "actCount") // 3.2.1, 3.3.0
    val atCounter: Inside<AtomicInteger> = of(at::class.java, "idCount")

    /** All of them, with those of `.wait`. */
    val all: List<Inside<*>> get() = found + WaitEvents.fields

    private fun <T> of(owner: Class<*>, vararg names: String): Inside<T> = Inside<T>({ owner }, *names).also { found += it }
}
