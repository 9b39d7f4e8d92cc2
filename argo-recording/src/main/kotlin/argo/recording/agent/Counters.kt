package argo.recording.agent

import argo.insides.Insides
import jason.asSemantics.Message
import jason.asSyntax.Plan
import java.util.concurrent.atomic.AtomicInteger

/**
 * Jason's counters for all agents of a program. They number variables, intentions, messages, suspended calls, calls of `.at`, and plans
 * without a name. A replay restores these counters. Names contain the numbers, and the order of Jason's maps depends on names.
 */
internal object Counters {
    private val known = Insides.run { listOf(variableCounter, intentionCounter, messageCounter, callCounter, atCounter, planCounter) }
        .filter { it.isThere } // without a counter, only some numbers differ
    private val all: List<AtomicInteger> = known.map { it[null] }
    private val ofIntentions = known.indexOf(Insides.intentionCounter)
    private val ofCalls = known.indexOf(Insides.callCounter)
    private val ofLabels = known.indexOf(Insides.planCounter)
    private val ofMessages = known.indexOf(Insides.messageCounter)

    /**
     * Returns the counters as they were before this agent took its own numbers in a cycle. At the beginning of the cycle the counters were
     * at [start]. Other agents may have taken numbers since.
     *
     * @param intention the number of the agent's first new intention; null if it has none
     * @param message the name of the first message that the agent sent; null if it sent none
     */
    fun before(start: List<Int>, intention: Int?, message: String?): List<Int> = start.mapIndexed { place, value ->
        when (place) {
            ofIntentions -> intention?.let { it - 1 } ?: value
            ofMessages -> message?.let(::numberBefore) ?: value
            else -> value
        }
    }

    fun hasNewIntentions(start: List<Int>) = ofIntentions in start.indices && all[ofIntentions].get() != start[ofIntentions]

    fun lastIntention(start: List<Int>): Int = start[ofIntentions]

    private fun numberBefore(message: String): Int? = when {
        message.startsWith(Message.msgIdSyncAskPrefix) -> message.removePrefix(Message.msgIdSyncAskPrefix).toIntOrNull()?.minus(2)
        else -> message.removePrefix(Message.msgIdPrefix).toIntOrNull()?.minus(1)
    }

    fun read(): List<Int> = all.map { it.get() }

    /** Returns true if the counters have not changed since [read] returned [values]. */
    fun isAt(values: List<Int>): Boolean = values.size == all.size && all.indices.all { all[it].get() == values[it] }

    /** Returns the lowest number in the names that Jason gave to [plans]; null if Jason has named none of them. */
    fun firstLabel(plans: List<Plan>): Int? =
        plans.mapNotNull { LABEL.matchEntire(it.label?.functor.orEmpty())?.groupValues?.get(1)?.toInt() }.minOrNull()

    fun nameFrom(label: Int) {
        all.getOrNull(ofLabels)?.set(label - 1)
    }

    /** Sets the counters to the [values] that [read] returned in another run. Older recordings of Jason 3.3.0 lack the counter of calls. */
    fun write(values: List<Int>) {
        val written = if (values.size == all.size) all else all.filterIndexed { place, _ -> place != ofCalls }
        written.zip(values).forEach { (counter, value) -> counter.set(value) }
    }

    private val LABEL = Regex("""p__(\d{1,9})""")
}
