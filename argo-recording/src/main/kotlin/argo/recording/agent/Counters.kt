package argo.recording.agent

import jason.asSemantics.Agent
import jason.asSemantics.ConcurrentInternalAction
import jason.asSemantics.Intention
import jason.asSemantics.Message
import jason.asSyntax.Plan
import jason.asSyntax.UnnamedVar
import jason.stdlib.at
import java.util.concurrent.atomic.AtomicInteger

/**
 * Jason's counters, which all agents of a program share: the numbers of variables, intentions, messages, suspended calls, `.at` and plans
 * without a name. They
 * are in names, and so in the order of Jason's maps.
 */
internal object Counters {
    private val all: List<AtomicInteger> = listOf(
        UnnamedVar::class.java to "varCont",
        Intention::class.java to "idCount",
        Message::class.java to "idCount",
        ConcurrentInternalAction::class.java to "actcount",
        at::class.java to "idCount",
        Agent::class.java.getMethod("getPL").returnType to "lastPlanLabel",
    ).mapNotNull { (type, name) -> counter(type, name) }

    private val ofIntentions = all.indexOf(counter(Intention::class.java, "idCount"))
    private val ofLabels = counter(Agent::class.java.getMethod("getPL").returnType, "lastPlanLabel")
    private val ofMessages = all.indexOf(counter(Message::class.java, "idCount"))

    /**
     * Where they stood before this agent's own draws in a cycle that began when they stood at [start]: other agents may have drawn
     * meanwhile.
     *
     * @param intention the number of its first new intention; null: it has none
     * @param message the name of the first message that it sent; null: none
     */
    fun before(start: List<Int>, intention: Int?, message: String?): List<Int> = start.mapIndexed { place, value ->
        when (place) {
            ofIntentions -> intention?.let { it - 1 } ?: value
            ofMessages -> message?.let(::numberBefore) ?: value
            else -> value
        }
    }

    /** Whether one has begun an intention since they stood at [start]. */
    fun hasNewIntentions(start: List<Int>) = ofIntentions in start.indices && all[ofIntentions].get() != start[ofIntentions]

    /** The number of the last intention when they stood at [start]. */
    fun lastIntention(start: List<Int>): Int = start[ofIntentions]

    /** A question that waits for its answer draws two. */
    private fun numberBefore(message: String): Int? = when {
        message.startsWith(Message.msgIdSyncAskPrefix) -> message.removePrefix(Message.msgIdSyncAskPrefix).toIntOrNull()?.minus(2)
        else -> message.removePrefix(Message.msgIdPrefix).toIntOrNull()?.minus(1)
    }

    /** Where they stand. */
    fun read(): List<Int> = all.map { it.get() }

    /** Whether they stand where [read] returned [values]. */
    fun isAt(values: List<Int>): Boolean = values.size == all.size && all.indices.all { all[it].get() == values[it] }

    /** The number of the first plan among [plans] that Jason has named; null: it has named none. */
    fun firstLabel(plans: List<Plan>): Int? =
        plans.mapNotNull { LABEL.matchEntire(it.label?.functor.orEmpty())?.groupValues?.get(1)?.toInt() }.minOrNull()

    /** The next plan that Jason names has the number [label]. */
    fun nameFrom(label: Int) {
        ofLabels?.set(label - 1)
    }

    /** Sets them to what [read] returned in another program. */
    fun write(values: List<Int>) = all.zip(values).forEach { (counter, value) -> counter.set(value) }

    private val LABEL = Regex("""p__(\d{1,9})""")

    private fun counter(type: Class<*>, name: String): AtomicInteger? = try {
        type.getDeclaredField(name).apply { isAccessible = true }.get(null) as? AtomicInteger
    } catch (_: ReflectiveOperationException) {
        null // another version of Jason: numbers differ then, and nothing else
    }
}
