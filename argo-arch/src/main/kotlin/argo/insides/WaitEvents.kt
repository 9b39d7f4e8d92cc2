package argo.insides

import jason.asSemantics.CircumstanceListener
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.LogicalFormula
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import jason.stdlib.wait
import java.lang.reflect.Constructor

/**
 * What a `.wait` of Jason's is while it waits: a listener of the agent's circumstance, of a class that nobody else can name, make or ask.
 * In another version of Jason that may be otherwise: all but [isThere] throw a [LinkageError] then.
 */
object WaitEvents {
    private const val NAME = "jason.stdlib.wait\$WaitEvent"
    private val type: Class<*> by lazy { inside(NAME) { Class.forName(NAME) } }
    private val make: Constructor<*> by lazy {
        inside("constructor of $NAME") {
            type.getDeclaredConstructor(
                wait::class.java, Trigger::class.java, LogicalFormula::class.java, Unifier::class.java, TransitionSystem::class.java,
                Long::class.java, Term::class.java,
            ).apply { isAccessible = true }
        }
    }

    val trigger: Inside<Trigger?> = of("te")
    val formula: Inside<LogicalFormula?> = of("formula")
    val reason: Inside<Literal> = of("pendingReason")

    /** The name under which its intention is pending. */
    val key: Inside<String> = of("tEvt")
    val unifier: Inside<Unifier> = of("un")
    val intention: Inside<Intention> = of("si")
    val isDropped: Inside<Boolean> = of("dropped")
    val elapsed: Inside<Term?> = of("elapsedTimeTerm")

    /** In ms; below 0: it has no timer. */
    val timeout: Inside<Long> = of("timeout")

    internal val fields: List<Inside<*>>
        get() = listOf(trigger, formula, reason, key, unifier, intention, isDropped, elapsed, timeout)

    /** Whether this version of Jason has all of it. */
    val isThere: Boolean get() = try {
        make.parameterCount > 0 && fields.all { it.isThere }
    } catch (_: LinkageError) {
        false
    }

    /** Whether [listener] is one. */
    fun isWait(listener: CircumstanceListener): Boolean = type.isInstance(listener)

    /** Makes one for the selected intention of [ts], which it suspends; with a [timeout] of 0 or more ms it begins a timer. */
    fun make(
        trigger: Trigger?, formula: LogicalFormula?, un: Unifier, ts: TransitionSystem, timeout: Long, elapsed: Term?,
    ): CircumstanceListener = make.newInstance(wait(), trigger, formula, un, ts, timeout, elapsed) as CircumstanceListener

    private fun <T> of(name: String) = Inside<T>({ type }, name)
}
