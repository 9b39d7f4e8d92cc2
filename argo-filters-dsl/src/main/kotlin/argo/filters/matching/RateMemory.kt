package argo.filters.matching

import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.Rate

internal class RatedPercept<P>(val percept: P, val text: PerceptText, val kind: String)

/** A [percept] that was let through at [atMs]. [numbers] are its numeric arguments, by index. */
internal class LetThrough<P>(val percept: P, val atMs: Long, val numbers: Map<Int, Double>) {
    /** The time at which a newer percept was first held back, or null. */
    var heldSinceMs: Long? = null
}

/** The [rule] holds a percept back until [dueMs]. Until then, the agent perceives [last]. */
internal class Hold<P>(val rule: CompiledRule, val dueMs: Long, val last: LetThrough<P>)

/**
 * The memory of a filter's rates: the last percept that was let through, for each rule and each kind of percept. Percepts that differ
 * only in numbers are of one kind. If several of them are received together, each gets a kind of its own by its position among them. A
 * percept is let through if a [SensorMemory] has forgotten its kind or has no room for it.
 */
internal class RateMemory<P : Any>(filter: PerceptionFilter?) {
    private val mode = filter?.mode

    val isEmpty: Boolean = filter == null || filter.rules.none { it.rate != null }

    private val memory = SensorMemory<LetThrough<P>>()
    private val counts = HashMap<String, Int>() // number of percepts in the group for each text without numbers
    private val kinds = HashMap<P, String>() // the kinds of the group's percepts

    /** Starts a new group of percepts that are received together. */
    fun begin() {
        counts.clear()
        kinds.clear()
    }

    /** Returns the group's next [percept], whose text is [text], with its kind. */
    fun next(percept: P, text: PerceptText): RatedPercept<P> {
        val key = text.key(ANY_NUMBER)
        val count = counts.merge(key, 1, Int::plus)
        val kind = if (count == 1) key else "$key$count"
        kinds[percept] = kind
        return RatedPercept(percept, text, kind)
    }

    /**
     * Returns [percept], whose text is [text], with its kind in the group. Outside of the group, a percept gets the kind of a first
     * percept.
     */
    fun known(percept: P, text: PerceptText) = RatedPercept(percept, text, kinds[percept] ?: text.key(ANY_NUMBER))

    /**
     * Returns the holds on [percept] at [nowMs] by the rules [met], which it meets. The decisive hold comes first. Empty if the percept
     * is let through or dropped for good.
     */
    fun holds(met: List<CompiledRule>, percept: RatedPercept<P>, nowMs: Long): List<Hold<P>> {
        if (met.isEmpty() || met.any { it.rate == null }) return emptyList()
        val holds = met.mapNotNull { hold(it, percept, nowMs) }
        return when {
            mode == Mode.DROP -> holds.sortedByDescending { it.dueMs }
            holds.size == met.size -> holds.sortedBy { it.dueMs }
            else -> emptyList()
        }
    }

    fun letThrough(met: List<CompiledRule>, percept: RatedPercept<P>, nowMs: Long) {
        for (rule in met) {
            if (rule.rate == null || !SensorMemory.isRoomFor(percept.text.length)) continue
            val last = memory[rule, percept.kind]
            if (last?.percept == percept.percept) last.heldSinceMs = null
            else memory.put(LetThrough(percept.percept, nowMs, numbers(percept.text)))
        }
    }

    private fun hold(rule: CompiledRule, percept: RatedPercept<P>, nowMs: Long): Hold<P>? {
        val rate = rule.rate?.takeIf { SensorMemory.isRoomFor(percept.text.length) } ?: return null
        val last = memory[rule, percept.kind]?.takeIf { it.percept != percept.percept } ?: return null
        if (hasMoved(rate, last, percept.text)) return null
        val dueMs = if (rate.everyMs != null) after(last.atMs, rate.everyMs) else after(last.heldSinceMs ?: nowMs, Rate.SETTLING_MS)
        return if (nowMs < dueMs) Hold(rule, dueMs, last) else null
    }

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
        /** Replaces every number in a key. No term has this text. */
        const val ANY_NUMBER = "#"
    }
}
