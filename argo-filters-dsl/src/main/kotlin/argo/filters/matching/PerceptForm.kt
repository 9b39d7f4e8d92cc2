package argo.filters.matching

import argo.filters.FunctorScanner
import argo.filters.Predicate
import argo.filters.Syntax
import argo.filters.Value

/** A percept in whatever form it came, as rules see it. */
internal interface PerceptForm {
    val predicate: Predicate
    val arity: Int

    /** Whether the percept has the argument or annotation that [condition] is on, and it meets the condition. */
    fun meets(condition: CompiledCondition): Boolean

    /** The number that the argument at [index] is, or null if it is none. */
    fun number(index: Int): Double?

    /** The percept without annotations, with [number] in place of each argument that is a number: what rates are counted by. */
    fun key(number: String): String

    /** The percept's text. */
    override fun toString(): String
}

/** A percept as it came off the line. */
internal class TextForm private constructor(private val text: String, private val head: FunctorScanner, private val tail: Long) : PerceptForm {
    override val predicate: Predicate = head.predicate()
    override val arity: Int = Outline.arity(tail)

    override fun meets(condition: CompiledCondition): Boolean = condition.holds(text, head.functorEnd, text.length, tail)

    override fun number(index: Int): Double? = (value(index) as? Value.Number)?.value

    override fun key(number: String): String = (0 until arity).joinToString(",", "$predicate(", ")") {
        when (val value = value(it)) {
            null -> part(it)
            is Value.Number -> number
            else -> value.toString()
        }
    }

    private fun value(index: Int): Value? = Value.ofOrNull(part(index))

    private fun part(index: Int): String {
        val start = Outline.argument(text, head.functorEnd, text.length, index)
        return text.substring(start, Outline.partEnd(text, start, text.length, ')'))
    }

    override fun toString(): String = text.trim()

    companion object {
        /** The percept that is written from [start] to [end], or null if none is. */
        fun of(text: CharSequence, start: Int = 0, end: Int = text.length): TextForm? {
            val percept = text.substring(start, end)
            val head = FunctorScanner(percept, 0, percept.length)
            if (!head.scan()) return null
            val tail = Outline.tail(percept, head.functorEnd, percept.length)
            if (tail < 0 || !isWritable(percept, head, tail)) return null
            return TextForm(percept, head, tail)
        }

        /** Truth values have neither arguments nor annotations. */
        private fun isWritable(text: String, head: FunctorScanner, tail: Long): Boolean {
            val isBare = Outline.arity(tail) == 0 && Outline.annotations(tail) == text.length
            return isBare || !Syntax.isTruthValue(text, head.functorStart, head.functorEnd)
        }
    }
}
