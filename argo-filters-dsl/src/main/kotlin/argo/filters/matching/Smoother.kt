package argo.filters.matching

import argo.filters.DecimalReader
import argo.filters.GroundTerm
import argo.filters.GroundTermReader
import java.util.BitSet

/**
 * Applies the smoothing rules of [matcher], and remembers the [Readings] of each sensor. Allocates nothing for a known sensor, unless a
 * rule annotates. Not safe for use by several threads at once.
 *
 * @param annotated returns a percept with the annotation `smoothed`
 */
internal class Smoother<P : Any>(
    private val matcher: PerceptMatcher, private val textOf: (P) -> String, private val annotated: (P) -> P,
) {
    /** By [rule], for this [reason], the percept [standing] would stand for another one. */
    class Replacement<P>(val rule: CompiledRule, val standing: P, val reason: String)

    private val memory = SensorMemory<Readings<P>>()

    private var isDoubted = false // true if the percept that was taken last is not credible

    /**
     * Takes the percepts that are [received] at [nowMs], and returns them with those that stand for them. Percepts among [old] that were in
     * the picture [before] are not taken again.
     */
    fun picture(received: List<P>, nowMs: Long, before: Picture<P>, old: Set<P>): Picture<P> {
        val earlier = if (old.isEmpty()) emptyMap() else before.placesOf(old)
        val standing = ArrayList<P>(received.size)
        val doubted = BitSet()
        for (percept in received) {
            val place = earlier[percept]
            standing += if (place != null) before.standing[place] else stands(percept, nowMs)
            doubted[standing.lastIndex] = if (place != null) before.isDoubted(place) else isDoubted
        }
        return Picture(received, standing, doubted)
    }

    /** Takes a [percept] that has come at [nowMs], and returns the percept that stands for it. */
    fun stands(percept: P, nowMs: Long): P = read(percept, percept.also { isDoubted = false }) { rule, known, number, unit ->
        val readings = known ?: readingsFor(rule).also(memory::put)
        readings.take(percept, number, unit, nowMs).also { isDoubted = readings.doubt != null }
    }

    /** Returns what would stand for [percept] if it came at [nowMs]; null: no rule smooths it. */
    fun replacement(percept: P, nowMs: Long): Replacement<P>? = read(percept, null) { rule, known, number, unit ->
        val readings = known?.copy() ?: readingsFor(rule)
        Replacement(rule, readings.take(percept, number, unit, nowMs), readings.reason(number))
    }

    private fun readingsFor(rule: CompiledRule) = Readings(checkNotNull(rule.smoothing), annotated)

    /** Returns the result of [found] for the rule that smooths [percept], its sensor's readings and its number; without a rule, [none]. */
    private inline fun <T> read(
        percept: P, none: T, found: (rule: CompiledRule, known: Readings<P>?, number: Double, unit: Double) -> T,
    ): T {
        val text = textOf(percept)
        val end = text.length
        if (end > SensorMemory.MAX_LENGTH) return none
        return scan(text, 0, end, none) { functor, functorEnd, tail, head ->
            val rule = matcher.smoothingRule(text, functor, functorEnd, tail, head)
            val argument = rule?.smoothing?.argument ?: return none
            if (argument >= TermBounds.arity(tail)) return none
            val from = TermBounds.argument(text, functorEnd, end, argument)
            val to = TermBounds.partEnd(text, from, end, ')')
            val number = number(text, from, to)
            if (!number.isFinite()) return none
            val unit = if (rule.smoothing.outliers == null) 0.0 else DecimalReader.unit(text, from, to)
            found(rule, memory.get(rule, text, functorEnd, from, to, TermBounds.annotations(tail)), number, unit)
        }
    }

    private fun number(text: String, from: Int, to: Int): Double {
        val plain = DecimalReader.plain(text, from, to)
        return if (plain.isNaN()) (GroundTermReader(text, from, to).readWhole() as? GroundTerm.Number)?.value ?: plain else plain
    }
}
