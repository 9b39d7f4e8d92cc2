package argo.filters.matching

import argo.filters.GroundTerm
import argo.filters.Syntax
import argo.filters.HeadScanner
import argo.filters.Predicate

/**
 * A percept in its text, as rules see it; [isPercept] tells whether it is one, and nothing else is defined where it is not.
 *
 * @param functor where the functor starts
 * @property functorEnd the character after the functor
 * @property tail what follows it, see [TermBounds.tail]
 * @param head its namespace and negation; null: it has neither
 */
internal class PerceptText(
    val text: CharSequence,
    private val start: Int,
    val end: Int,
    private val functor: Int,
    val functorEnd: Int,
    val tail: Long,
    private val head: HeadScanner?,
) {
    val isPercept: Boolean
        get() = tail >= 0

    val arity: Int
        get() = TermBounds.arity(tail)

    val length: Int
        get() = end - start

    fun predicate(): Predicate = head?.predicate() ?: Predicate(text.substring(functor, functorEnd))

    fun rulesIn(index: RuleIndex): Array<CompiledRule> = index.find(text, functor, functorEnd)

    /** Whether the percept, whose functor is that of [predicate], has its negation and namespace too. */
    fun isOf(predicate: Predicate): Boolean =
        (head?.negated ?: false) == predicate.negated && (head?.namespace ?: Predicate.DEFAULT_NAMESPACE) == predicate.namespace

    /** The number that the argument at [index] is; null if it is none, or there is none. */
    fun number(index: Int): Double? = if (index < arity) (GroundTerm.ofOrNull(part(index)) as? GroundTerm.Number)?.value else null

    /** The percept without annotations, with [number] in place of each argument that is a number: rates count percepts by it. */
    fun key(number: String): String = (0 until arity).joinToString(",", "${predicate()}(", ")") {
        when (val value = GroundTerm.ofOrNull(part(it))) {
            null -> part(it)
            is GroundTerm.Number -> number
            else -> value.toString()
        }
    }

    private fun part(index: Int): String =
        TermBounds.argument(text, functorEnd, end, index).let { text.substring(it, TermBounds.partEnd(text, it, end, ')')) }

    /** The percept's text. */
    override fun toString(): String = text.substring(start, end).trim()
}

/**
 * The percept that [text] may hold from [start] to [end].
 *
 * Inlined, and split from the scanning, so that the compiler can keep an instance that does not outlive a decision in registers.
 */
@Suppress("NOTHING_TO_INLINE")
internal inline fun perceptIn(text: CharSequence, start: Int = 0, end: Int = text.length): PerceptText {
    var functor = Syntax.skipBlanks(text, start, end)
    var functorEnd = TermBounds.plainFunctorEnd(text, functor, end)
    var head: HeadScanner? = null
    if (functorEnd < 0) {
        head = HeadScanner(text, start, end)
        functor = head.functorStart
        functorEnd = head.functorEnd
    }
    return PerceptText(text, start, end, functor, functorEnd, TermBounds.tailOf(text, functor, functorEnd, end), head)
}
