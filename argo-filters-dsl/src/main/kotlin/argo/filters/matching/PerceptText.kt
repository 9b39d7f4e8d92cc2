package argo.filters.matching

import argo.filters.HeadScanner
import argo.filters.Predicate
import argo.filters.Value
import argo.filters.ValueReader

/**
 * A percept in its text, which stands in [text] from [start] to [end], as rules see it.
 *
 * Everything but [isPercept] and [toString] is defined only where the text is a percept. An instance that does not outlive a decision costs
 * no memory: the compiler keeps its fields in registers.
 */
internal class PerceptText(private val text: CharSequence, private val start: Int, private val end: Int) {
    private val head = HeadScanner(text, start, end)
    private val tail: Long = if (head.functorEnd < 0) TermBounds.NO_TAIL else TermBounds.tail(text, head.functorEnd, end)

    constructor(text: String) : this(text, 0, text.length)

    /** Whether the text is a percept. Truth values are none if something stands behind them. */
    val isPercept: Boolean
        get() = tail >= 0 && (!head.isTruthValue || arity == 0 && TermBounds.annotations(tail) == end)

    val arity: Int
        get() = TermBounds.arity(tail)

    val length: Int
        get() = end - start

    fun predicate(): Predicate = head.predicate()

    fun rulesIn(index: RuleIndex): Array<CompiledRule> = index.find(text, head.functorStart, head.functorEnd)

    /** Whether the percept, whose functor is that of [predicate], has its negation and namespace too. */
    fun isOf(predicate: Predicate): Boolean = head.negated == predicate.negated && head.namespace == predicate.namespace

    /** Whether the percept has an argument at [index] that meets [test]. */
    fun argumentMeets(index: Int, test: CompiledTest): Boolean {
        if (index >= arity) return false
        val argument = argument(index)
        return test.isMetBy(text, argument, TermBounds.partEnd(text, argument, end, ')'))
    }

    /** Whether the percept has an annotation that meets [condition]. */
    fun anyAnnotationMeets(condition: (Value?) -> Boolean): Boolean {
        var i = TermBounds.annotations(tail)
        while (i < end && text[i] != ']') {
            val annotation = TermBounds.annotation(text, i, end)
            if (annotation == end || text[annotation] == ']') return false
            i = TermBounds.partEnd(text, annotation, end, ']')
            if (condition(ValueReader(text, annotation, i).readWhole())) return true
        }
        return false
    }

    /** The number that the argument at [index] is; null if it is none, or there is none. */
    fun number(index: Int): Double? = if (index < arity) (Value.ofOrNull(part(index)) as? Value.Number)?.value else null

    /** The percept without annotations, with [number] in place of each argument that is a number: rates count percepts by it. */
    fun key(number: String): String = (0 until arity).joinToString(",", "${predicate()}(", ")") {
        when (val value = Value.ofOrNull(part(it))) {
            null -> part(it)
            is Value.Number -> number
            else -> value.toString()
        }
    }

    private fun argument(index: Int) = TermBounds.argument(text, head.functorEnd, end, index)

    private fun part(index: Int): String = argument(index).let { text.substring(it, TermBounds.partEnd(text, it, end, ')')) }

    /** The percept's text. */
    override fun toString(): String = text.substring(start, end).trim()
}
