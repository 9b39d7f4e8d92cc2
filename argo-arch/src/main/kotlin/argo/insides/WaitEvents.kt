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
 * The object by which Jason's `.wait` waits. The object listens to the agent's circumstance, and its class is private. If another version
 * of Jason lacks the class or a member, only [isThere] works, and all other members throw a [LinkageError].
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

    /** The key of the suspended intention in Jason's map of pending intentions. */
    val key: Inside<String> = of("tEvt")
    val unifier: Inside<Unifier> = of("un")
    val intention: Inside<Intention> = of("si")
    val isDropped: Inside<Boolean> = of("dropped")
    val elapsed: Inside<Term?> = of("elapsedTimeTerm")

    /** The timeout in ms; below 0 if the `.wait` has no timer. */
    val timeout: Inside<Long> = of("timeout")

    internal val fields: List<Inside<*>>
        get() = listOf(trigger, formula, reason, key, unifier, intention, isDropped, elapsed, timeout)

    /** True if this version of Jason has the class and all members. */
    val isThere: Boolean get() = try {
        make.parameterCount > 0 && fields.all { it.isThere }
    } catch (_: LinkageError) {
        false
    }

    /** Returns true if [listener] belongs to a `.wait`. */
    fun isWait(listener: CircumstanceListener): Boolean = type.isInstance(listener)

    /** Makes the listener of a `.wait` and suspends the selected intention of [ts]. A [timeout] of 0 ms or more starts a timer. */
    fun make(
        trigger: Trigger?, formula: LogicalFormula?, un: Unifier, ts: TransitionSystem, timeout: Long, elapsed: Term?,
    ): CircumstanceListener = make.newInstance(wait(), trigger, formula, un, ts, timeout, elapsed) as CircumstanceListener

    private fun <T> of(name: String) = Inside<T>({ type }, name)
}
