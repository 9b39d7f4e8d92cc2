package argo.recording.agent

import jason.asSemantics.Circumstance
import jason.asSemantics.CircumstanceListener
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.LogicalFormula
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import jason.bb.DefaultBeliefBase
import jason.stdlib.wait
import java.lang.reflect.Field
import java.util.concurrent.ConcurrentHashMap

/** Fields of Jason's for which it has no function. Another version of Jason may have others: the first use is a [LinkageError] then. */
internal object Insides {
    val atomicEvent = field(Circumstance::class.java, "AE")
    val atomicIntention = field(Circumstance::class.java, "AI")
    val isAtomicSuspended = field(Circumstance::class.java, "atomicIntSuspended")
    val goalConditions = field(Circumstance::class.java, "intentionsWithGoalCondition")
    val selectedEvent = field(Circumstance::class.java, "SE")
    val selectedOption = field(Circumstance::class.java, "SO")
    val selectedIntention = field(Circumstance::class.java, "SI")
    val cyclesUnperceived = field(TransitionSystem::class.java, "nrcslbr")
    val isAsleep = field(TransitionSystem::class.java, "sleepingEvt")
    val tasks = field(TransitionSystem::class.java, "taskForBeginOfCycle")
    val percepts = field(DefaultBeliefBase::class.java, "percepts")

    private fun field(type: Class<*>, name: String): Field = type.getDeclaredField(name).apply { isAccessible = true }
}

/** The `.wait`s of Jason's, which listen to the agent's circumstance. */
internal object Waits {
    private val type = Class.forName("jason.stdlib.wait\$WaitEvent")
    private val make = type.declaredConstructors.single { it.parameterCount == PARAMETERS }.apply { isAccessible = true }

    /** True; where Jason has others, the first use of this object is a [LinkageError]. */
    val isThere = true

    /** Whether [listener] is one. */
    fun isWait(listener: CircumstanceListener): Boolean = type.isInstance(listener)

    /** How many ms the timer of [wait] takes; below 0: it has none. */
    fun timeoutOf(wait: CircumstanceListener): Long = get(wait, "timeout")

    /** The intention that waits. */
    fun intentionOf(wait: CircumstanceListener): Intention = get(wait, "si")

    /** [wait] as it is written, with the number of its [timer]. */
    fun describe(wait: CircumstanceListener, timer: Int?, isListening: Boolean) = Wait(
        timer, isListening, get<Trigger?>(wait, "te"), get<LogicalFormula?>(wait, "formula"), get(wait, "pendingReason"), get(wait, "tEvt"),
        get(wait, "un"), get(wait, "si"), get(wait, "dropped"), get<Term?>(wait, "elapsedTimeTerm"),
    )

    /**
     * Makes the `.wait` that [described] is for the agent of [ts], which begins a timer if it has one. It is registered nowhere.
     * The agent's listeners and pending intentions are to be set afterwards.
     */
    fun make(described: Wait, ts: TransitionSystem): CircumstanceListener {
        val reason = described.intention.suspendedReason
        Insides.selectedIntention.set(ts.c, described.intention)
        ts.c.listeners.clear() // others would take the new one for news
        val timeout = if (described.timer == null) -1L else 0L
        val made = make.newInstance(wait(), described.trigger, described.formula, described.un, ts, timeout, described.elapsed)
        described.intention.suspendedReason = reason
        set(made, "pendingReason", described.reason)
        set(made, "tEvt", described.key)
        set(made, "dropped", described.isDropped)
        return made as CircumstanceListener
    }

    @Suppress("UNCHECKED_CAST")
    private fun <T> get(wait: Any, name: String): T = field(name).get(wait) as T

    private fun set(wait: Any, name: String, value: Any) = field(name).set(wait, value)

    private fun field(name: String): Field = fields.getOrPut(name) { type.getDeclaredField(name).apply { isAccessible = true } }

    private val fields = ConcurrentHashMap<String, Field>()

    /** The action that it is of, and those of its constructor. */
    private const val PARAMETERS = 7
}
