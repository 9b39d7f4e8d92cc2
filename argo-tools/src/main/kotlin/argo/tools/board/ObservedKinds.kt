package argo.tools.board

import javino.PerceptArgument
import javino.PerceptKind
import javino.PerceptTerm
import java.math.BigDecimal
import java.util.Optional

/**
 * The kinds of the observed percepts. Percepts with equal functor and arity form one kind. If an argument was always a number, the kind has
 * its range. If it was always one of a few atoms, the kind has these atoms as choices. Percepts with a quoted functor, and kinds beyond
 * [MAX_KINDS], are only counted in [others].
 */
internal class ObservedKinds {
    private val kinds = LinkedHashMap<String, Pair<String, List<Argument>>>() // functor and arguments of each kind, by `functor/arity`

    /** The number of percepts without a kind of their own. */
    var others = 0L
        private set

    fun add(percept: String) {
        val term = PerceptTerm.of(percept)
        val kind = kinds[term.indicator()] ?: begin(term)
        if (kind == null) others++ else kind.second.zip(term.arguments()).forEach { (argument, value) -> argument.add(value) }
    }

    private fun begin(term: PerceptTerm): Pair<String, List<Argument>>? =
        if (kinds.size == MAX_KINDS || !FUNCTOR.matches(term.functor())) null
        else (term.functor() to term.arguments().map { Argument() }).also { kinds[term.indicator()] = it }

    fun kinds(): List<PerceptKind> = kinds.values.map { (functor, arguments) -> PerceptKind(functor, arguments.map { it.observed() }) }

    private class Argument {
        private var range: ClosedRange<BigDecimal>? = null
        private val atoms = LinkedHashSet<String>()
        private var isAnything = false

        fun add(value: String) {
            when {
                NUMBER.matches(value) -> range = around(value.toBigDecimal())
                ATOM.matches(value) && atoms.size < MAX_CHOICES -> atoms += value
                value !in atoms -> isAnything = true
            }
            isAnything = isAnything || range != null && atoms.isNotEmpty()
        }

        private fun around(number: BigDecimal) = minOf(range?.start ?: number, number)..maxOf(range?.endInclusive ?: number, number)

        fun observed(): PerceptArgument {
            val numbers = range
            return when {
                isAnything -> PerceptArgument.Anything()
                numbers == null -> PerceptArgument.Choice(atoms.toList())
                else -> PerceptArgument.Quantity("", Optional.of(numbers.start), Optional.of(numbers.endInclusive))
            }
        }
    }

    companion object {
        const val MAX_KINDS = 200
        private const val MAX_CHOICES = 12
        private val FUNCTOR = Regex("~?[a-z]\\w*")
        private val NUMBER = Regex("-?[0-9]{1,30}(\\.[0-9]{1,30})?")
        private val ATOM = Regex("[a-z]\\w{0,99}")
    }
}
