package argo.view

import javino.PerceptArgument.Quantity
import javino.PerceptKind
import javino.PerceptTerm
import kotlinx.serialization.Serializable
import kotlin.jvm.optionals.getOrNull

/**
 * A percept, compared with its board's description of percepts.
 *
 * @property text the percept with its units
 * @property deviation the difference between the percept and the description, in words; null if there is none
 * @property ranges the range of each number in the percept, in order; null if no range is described
 */
@Serializable
internal data class DescribedPercept(val text: String, val deviation: String?, val ranges: List<NumberRange?>) {
    companion object {
        /** Compares [percept] with [kinds], which has at least one kind. */
        fun of(percept: String, kinds: List<PerceptKind>): DescribedPercept {
            val term = PerceptTerm.of(percept)
            val kind = PerceptKind.of(term, kinds).getOrNull()
            val deviation = PerceptKind.deviationOf(term, kinds).getOrNull()
            return DescribedPercept(kind?.withUnits(term) ?: percept, deviation, kind?.let { rangesOf(term, it) }.orEmpty())
        }

        private fun rangesOf(term: PerceptTerm, kind: PerceptKind): List<NumberRange?> =
            term.arguments().zip(kind.arguments()).flatMap { (text, argument) ->
                val numbers = NUMBER.findAll(text).count()
                val range = (argument as? Quantity)?.takeIf { numbers == 1 }?.let(NumberRange::of)
                List(numbers) { range }
            }
    }
}

/**
 * The numbers that a board may send.
 *
 * @property unit their unit; empty if none is given
 * @property min the smallest number; null if there is no limit
 * @property max the largest number; null if there is no limit
 */
@Serializable
internal data class NumberRange(val unit: String, val min: Double?, val max: Double?) {
    companion object {
        fun of(quantity: Quantity) =
            NumberRange(quantity.unit(), quantity.min().getOrNull()?.toDouble(), quantity.max().getOrNull()?.toDouble())
    }
}

/** Matches the numbers in a percept. A number in a name is part of the name, and does not match. */
internal val NUMBER = Regex("""(?<!\w)[-+]?\d+(\.\d+)?([eE][-+]?\d+)?""")
