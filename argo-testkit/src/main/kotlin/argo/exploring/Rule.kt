package argo.exploring

import kotlin.time.Duration

/**
 * What must hold in each run. A project writes its own:
 *
 *     val neverReverses = rule("never reverses") { run ->
 *         run.trace.filterIsInstance<Issued>().firstOrNull { it.command == "back" }?.let { Breach(it.at, "it reversed") }
 *     }
 *
 * It must depend on the run alone.
 */
fun interface Rule {
    /** Where [run] breaks it first; null: it is kept. */
    fun breachIn(run: Run): Breach?

    /** What must hold, in a few words. */
    val name: String get() = javaClass.simpleName
}

/** Where a rule is broken: at which time, and how, for a person. */
data class Breach(val at: Duration, val how: String)

/** A rule called [name]. */
fun rule(name: String, breachIn: (Run) -> Breach?): Rule = object : Rule {
    override val name = name

    override fun breachIn(run: Run) = breachIn(run)

    override fun toString() = name
}

/** The rules of this package, which can be printed as a program: `toString` is the call that makes them. */
internal abstract class ReadyRule(override val name: String, private vararg val arguments: Any) : Rule {
    /** The name of the function that makes it. */
    val function: String get() = javaClass.simpleName.replaceFirstChar(Char::lowercase)

    final override fun toString() =
        function + arguments.joinToString(prefix = "(", postfix = ")", transform = ::argument)

    private fun argument(value: Any): String =
        if (value is Collection<*>) "listOf(${value.joinToString { kotlinOf(it as Any) }})" else kotlinOf(value)

    /** The first breach of all agents in [run]. */
    final override fun breachIn(run: Run): Breach? = run.agents.mapNotNull { breachIn(run, it) }.minByOrNull { it.at }

    /** Where [agent] breaks it first. */
    protected abstract fun breachIn(run: Run, agent: String): Breach?
}

/** Whether [command] is [pattern], or begins with it as its name: `drive` stands for `drive(3)`. */
internal fun isCommand(command: String, pattern: String) = command == pattern || command.startsWith("$pattern(")

internal fun List<String>.hasCommand(command: String) = any { isCommand(command, it) }

/** [time] in whole milliseconds. */
internal fun inMs(time: Duration) = "${time.inWholeMilliseconds} ms"
