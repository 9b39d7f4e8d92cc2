package argo.filters.matching

import argo.filters.Syntax

/** Finds rules by the functor in a percept's text, without allocation. Uses a hash table with open addressing. */
internal class RuleIndex(rules: List<CompiledRule>) {
    private val functors: Array<String?>
    private val rulesOf: Array<Array<CompiledRule>>
    private val mask: Int
    private val shift: Int

    init {
        val byFunctor = rules.groupBy { it.rule.predicate.functor }
        val size = Integer.highestOneBit(maxOf(byFunctor.size, 1)) * SPACE
        functors = arrayOfNulls(size)
        rulesOf = Array(size) { emptyArray() }
        mask = size - 1
        shift = Integer.numberOfLeadingZeros(mask)
        byFunctor.forEach { (functor, rules) ->
            var slot = slot(functor.hashCode())
            while (functors[slot] != null) slot = slot + 1 and mask
            functors[slot] = functor
            rulesOf[slot] = rules.toTypedArray()
        }
    }

    /** Returns the rules for the functor in [text] from [start] to [end], in the order of the filter. */
    fun find(text: CharSequence, start: Int, end: Int): Array<CompiledRule> {
        var hash = 0
        for (i in start until end) hash = 31 * hash + text[i].code
        var slot = slot(hash)
        while (true) {
            val functor = functors[slot] ?: return NO_RULES
            if (Syntax.isAt(text, start, end, functor)) return rulesOf[slot]
            slot = slot + 1 and mask
        }
    }

    /** Multiplies by the golden ratio and uses the high bits. Numbered names (`s1`, `s2`) then spread over the whole table. */
    private fun slot(hash: Int) = (hash * GOLDEN_RATIO) ushr shift

    private companion object {
        const val SPACE = 4
        const val GOLDEN_RATIO = -0x61c88647
        val NO_RULES = emptyArray<CompiledRule>()
    }
}
