package argo.recording.agent

import jason.asSemantics.ConcurrentInternalAction
import jason.asSemantics.Intention
import jason.asSemantics.Message
import jason.asSyntax.UnnamedVar
import jason.stdlib.at
import java.util.concurrent.atomic.AtomicInteger

/**
 * Jason's counters, which all agents of a program share: the numbers of variables, intentions, messages, suspended calls and `.at`. They
 * are in names, and so in the order of Jason's maps.
 */
internal object Counters {
    private val all: List<AtomicInteger> = listOf(
        UnnamedVar::class.java to "varCont",
        Intention::class.java to "idCount",
        Message::class.java to "idCount",
        ConcurrentInternalAction::class.java to "actcount",
        at::class.java to "idCount",
    ).mapNotNull { (type, name) -> counter(type, name) }

    /** Where they stand. */
    fun read(): List<Int> = all.map { it.get() }

    /** Whether they stand where [read] returned [values]. */
    fun isAt(values: List<Int>): Boolean = values.size == all.size && all.indices.all { all[it].get() == values[it] }

    /** Sets them to what [read] returned in another program. */
    fun write(values: List<Int>) = all.zip(values).forEach { (counter, value) -> counter.set(value) }

    private fun counter(type: Class<*>, name: String): AtomicInteger? = try {
        type.getDeclaredField(name).apply { isAccessible = true }.get(null) as? AtomicInteger
    } catch (_: ReflectiveOperationException) {
        null // another version of Jason: numbers differ then, and nothing else
    }
}
