package argo.filters.matching

import argo.filters.Condition
import argo.filters.GroundTerm
import argo.filters.HeadScanner
import argo.filters.Predicate
import argo.filters.Syntax

/**
 * The text of a percept, divided into the parts that rules test.
 *
 * @param tail arity and annotations, see [TermBounds.tail]
 * @param head the functor's namespace and negation, or null if it has neither
 */
internal class PerceptText private constructor(
    private val text: String,
    private val functor: Int,
    private val functorEnd: Int,
    private val tail: Long,
    private val head: HeadScanner?,
) {
    private val end = text.length

    val arity: Int = TermBounds.arity(tail)

    val length: Int
        get() = text.length

    fun predicate(): Predicate = head?.predicate() ?: Predicate(text.substring(functor, functorEnd))

    /** Returns the rules of [index] for percepts with this name and arity. Does not test their conditions. */
    fun rulesIn(index: RuleIndex): List<CompiledRule> = index.find(text, functor, functorEnd).filter { it.isFor(tail, head) }

    /** Returns true if the percept meets the conditions of [rule], a rule for percepts with this name and arity. */
    fun meets(rule: CompiledRule, hysteresis: Hysteresis?): Boolean = rule.areMet(text, functorEnd, end, tail, hysteresis)

    /** Returns the first condition of [rule] that the percept does not meet. */
    fun failing(rule: CompiledRule, hysteresis: Hysteresis?): Condition = rule.failing(text, functorEnd, end, tail, hysteresis)

    /** Returns the number at argument [index], or null if there is no number. */
    fun number(index: Int): Double? = if (index < arity) (GroundTerm.ofOrNull(part(index)) as? GroundTerm.Number)?.value else null

    /**
     * Returns the text without annotations, with [number] in place of each numeric argument. Rates use this text as the kind of the
     * percept.
     */
    fun key(number: String): String = (0 until arity).joinToString(",", "${predicate()}(", ")") {
        when (val value = GroundTerm.ofOrNull(part(it))) {
            null -> part(it)
            is GroundTerm.Number -> number
            else -> value.toString()
        }
    }

    fun argument(index: Int): String? = if (index < arity) part(index).trim() else null

    private fun part(index: Int): String =
        TermBounds.argument(text, functorEnd, end, index).let { text.substring(it, TermBounds.partEnd(text, it, end, ')')) }

    override fun toString(): String = text.trim()

    companion object {
        /** Reads the percept in [text]. Returns null if [text] is no percept. */
        fun of(text: String): PerceptText? = scan(text, 0, text.length, null) { functor, functorEnd, tail, head ->
            PerceptText(text, functor, functorEnd, tail, head)
        }
    }
}

/** Finds the percept in [text] from [start] to [end], and returns the result of [found]. Returns [none] if there is no percept. */
internal inline fun <T> scan(
    text: CharSequence,
    start: Int,
    end: Int,
    none: T,
    found: (functor: Int, functorEnd: Int, tail: Long, head: HeadScanner?) -> T,
): T {
    var functor = Syntax.skipBlanks(text, start, end)
    var functorEnd = TermBounds.plainFunctorEnd(text, functor, end)
    var head: HeadScanner? = null
    if (functorEnd < 0) {
        head = HeadScanner(text, start, end)
        functor = head.functorStart
        functorEnd = head.functorEnd
    }
    val tail = TermBounds.tailOf(text, functor, functorEnd, end)
    return if (tail < 0) none else found(functor, functorEnd, tail, head)
}
