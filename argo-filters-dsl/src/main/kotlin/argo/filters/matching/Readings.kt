package argo.filters.matching

import argo.filters.DecimalReader
import argo.filters.GroundTerm
import argo.filters.SmoothingRule
import kotlin.math.abs

/**
 * The last percepts of one sensor. A smoothing [rule] selects one of these percepts.
 *
 * @param annotated returns a percept with the annotation `smoothed`
 */
internal class Readings<P : Any>(private val rule: SmoothingRule, private val annotated: (P) -> P) {
    private var judged = rule.outliers?.let { SortedWindow(it.among) }
    private var credible = rule.median?.let(::SortedWindow)
    private val percepts = ArrayList<P>(rule.median ?: 1) // the percepts for the numbers in credible, at equal indices
    private val last = Reading(Double.NaN, 0)
    private val doubted = Reading(Double.NaN, 0)
    private var doubts = 0

    /** The reason why the newest percept is not credible, or null if it is credible. */
    var doubt: Doubt? = null
        private set

    enum class Doubt { TOO_FAST, OUTLIER }

    private class Reading(var number: Double, var ms: Long) {
        fun set(number: Double, ms: Long) {
            this.number = number
            this.ms = ms
        }

        /**
         * Returns true if [number] is possible at [nowMs] after this reading, for a sensor whose number changes by at most [rate] a
         * second.
         */
        fun canBecome(number: Double, nowMs: Long, rate: Double) = abs(number - this.number) * MS_PER_SECOND <= rate * (nowMs - ms)
    }

    /**
     * Adds the newest [percept] at [nowMs], and returns the percept that replaces it. Its finite [number] is in [text] from [from] to
     * [to].
     */
    fun take(percept: P, text: String, from: Int, to: Int, number: Double, nowMs: Long): P {
        doubt = when {
            isTooFast(number, nowMs) -> Doubt.TOO_FAST
            isFarOff(number) && exceeds(number, DecimalReader.unit(text, from, to)) -> Doubt.OUTLIER
            else -> null
        }
        if (doubt == null) accept(if (rule.annotates) annotated(percept) else percept, number, nowMs)
        return percepts[credible?.median() ?: 0]
    }

    private fun isTooFast(number: Double, nowMs: Long): Boolean {
        val rate = rule.maxRate ?: return false
        if (last.number.isNaN() || last.canBecome(number, nowMs, rate)) return false
        doubts = if (doubts > 0 && doubted.canBecome(number, nowMs, rate)) doubts + 1 else 1
        doubted.set(number, nowMs)
        return doubts < CONFIRMING
    }

    /** Adds [number] to [judged]. Returns true if [number] is too many deviations from their median. */
    private fun isFarOff(number: Double): Boolean {
        val window = judged ?: return false
        window.add(number)
        return window.count > 2 && exceeds(number, OF_NORMAL_NOISE * window.medianDistance())
    }

    /** Returns true if [number] is further from the median of [judged] than the rule allows, for this [deviation]. */
    private fun exceeds(number: Double, deviation: Double): Boolean {
        val outliers = rule.outliers ?: return false
        return judged?.let { abs(number - it.middle()) > outliers.deviations * deviation } == true
    }

    private fun accept(percept: P, number: Double, nowMs: Long) {
        doubts = 0
        last.set(number, nowMs)
        val place = credible?.add(number) ?: 0
        if (place < percepts.size) percepts[place] = percept else percepts += percept
    }

    /** Returns why another percept replaces the newest one, which has this [number]. */
    fun reason(number: Double): String = when (doubt) {
        null -> "the median of the last ${credible?.count} is ${credible?.let { shown(it[it.median()]) }}"
        Doubt.TOO_FAST -> "${shown(last.number)} cannot have become ${shown(number)} so fast"
        Doubt.OUTLIER ->
            "${shown(number)} is an outlier, since the median of the last ${judged?.count} is ${judged?.let { shown(it.middle()) }}"
    }

    private fun shown(number: Double) = GroundTerm.Number(number)

    /** Returns a copy of these readings. */
    fun copy() = Readings(rule, annotated).also {
        it.judged = judged?.copy()
        it.credible = credible?.copy()
        it.percepts += percepts
        it.last.set(last.number, last.ms)
        it.doubted.set(doubted.number, doubted.ms)
        it.doubts = doubts
    }

    private companion object {
        const val MS_PER_SECOND = 1_000

        /** The number of percepts in a row that confirm each other, if each can follow the previous one. */
        const val CONFIRMING = 3

        /** The standard deviation of normal noise, in median absolute deviations. */
        const val OF_NORMAL_NOISE = 1.4826
    }
}
