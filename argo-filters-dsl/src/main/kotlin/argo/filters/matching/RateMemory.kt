package argo.filters.matching

import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.Rate

/** A [percept] that was let through at [atMs], with its numeric arguments. */
internal class LetThrough<P>(val percept: P, val atMs: Long, val numbers: Map<Int, Double>) {
    /** The time at which the first newer percept was held back; null: no newer percept was held back. */
    var heldSinceMs: Long? = null
}

/** The [rule] holds a percept back until [dueMs]; while it does, the agent perceives [last]. */
internal class Hold<P>(val rule: CompiledRule, val dueMs: Long, val last: LetThrough<P>)

/**
 * The memory of a filter's rates: the last percept that was let through, for each rule and each kind of percept. Percepts that differ only
 * in numbers are of one kind. Percepts that a [SensorMemory] has forgotten, or has no room for, are let through.
 */
internal class RateMemory<P : Any>(filter: PerceptionFilter?) {
    private val mode = filter?.mode

    val isEmpty: Boolean = filter == null || filter.rules.none { it.rate != null }

    private val memory = SensorMemory<LetThrough<P>>()

    /**
     * Returns the holds of the rules that [percept] [met] at [nowMs], the decisive hold first; empty if the percept is let through or
     * dropped for good.
     */
    fun holds(met: List<CompiledRule>, text: PerceptText, percept: P, nowMs: Long): List<Hold<P>> {
        if (met.isEmpty() || met.any { it.rate == null }) return emptyList()
        val holds = met.mapNotNull { hold(it, text, percept, nowMs) }
        return when {
            mode == Mode.DROP -> holds.sortedByDescending { it.dueMs }
            holds.size == met.size -> holds.sortedBy { it.dueMs }
            else -> emptyList()
        }
    }

    fun letThrough(met: List<CompiledRule>, text: PerceptText, percept: P, nowMs: Long) {
        for (rule in met) {
            if (rule.rate == null || !SensorMemory.isRoomFor(text.length)) continue
            val last = memory[rule, text.key(ANY_NUMBER)]
            if (last?.percept == percept) last.heldSinceMs = null else memory.put(LetThrough(percept, nowMs, numbers(text)))
        }
    }

    private fun hold(rule: CompiledRule, text: PerceptText, percept: P, nowMs: Long): Hold<P>? {
        val rate = rule.rate?.takeIf { SensorMemory.isRoomFor(text.length) } ?: return null
        val last = memory[rule, text.key(ANY_NUMBER)]?.takeIf { it.percept != percept } ?: return null
        if (hasMoved(rate, last, text)) return null
        val dueMs = if (rate.everyMs != null) after(last.atMs, rate.everyMs) else after(last.heldSinceMs ?: nowMs, Rate.SETTLING_MS)
        return if (nowMs < dueMs) Hold(rule, dueMs, last) else null
    }

    /** Returns the time [ms] after [startMs], limited to [Long.MAX_VALUE]. */
    private fun after(startMs: Long, ms: Long) = if (startMs > Long.MAX_VALUE - ms) Long.MAX_VALUE else startMs + ms

    private fun hasMoved(rate: Rate, last: LetThrough<P>, text: PerceptText): Boolean = rate.deadbands.any { deadband ->
        val arguments = deadband.argument?.let(::listOf) ?: last.numbers.keys
        arguments.any { hasMoved(last.numbers[it], text.number(it), deadband.width) }
    }

    /** Returns true if a number has moved. An argument that is no number counts as moved. */
    private fun hasMoved(last: Double?, now: Double?, width: Double) = last == null || now == null || Math.abs(now - last) >= width

    private fun numbers(text: PerceptText): Map<Int, Double> =
        (0 until text.arity).mapNotNull { index -> text.number(index)?.let { index to it } }.toMap()

    companion object {
        /** Replaces every number in a key, since no term has this text. */
        const val ANY_NUMBER = "#"
    }
}
