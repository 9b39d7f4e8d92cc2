package argo.exploring

import kotlin.time.Duration

/**
 * A condition that must hold in each run. A project writes its own:
 *
 *     val neverReverses = rule("never reverses") { run ->
 *         run.trace.filterIsInstance<Issued>().firstOrNull { it.command == "back" }?.let { Breach(it.at, "it reversed") }
 *     }
 *
 * Its result must depend only on the run.
 */
fun interface Rule {
    /** Returns where [run] breaks it first; null: it is kept. */
    fun breachIn(run: Run): Breach?

    /** The condition in a few words. */
    val name: String get() = javaClass.simpleName
}

/** A breach of a rule: its time, and a description for a person. */
data class Breach(val at: Duration, val how: String)

/** Makes a rule called [name]. */
fun rule(name: String, breachIn: (Run) -> Breach?): Rule = object : Rule {
    override val name = name

    override fun breachIn(run: Run) = breachIn(run)

    override fun toString() = name
}

/**
 * A rule of this package, which can be printed as a program: `toString` is the call that makes it.
 *
 * @property function makes it, from [arguments]
 * @property breachOf returns where an agent breaks it first in a run; null: it keeps the rule
 */
internal class ReadyRule(
    val function: String,
    override val name: String,
    private vararg val arguments: Any,
    private val breachOf: (run: Run, agent: String) -> Breach?,
) : Rule {
    override fun toString() = function + arguments.joinToString(prefix = "(", postfix = ")", transform = ::argument)

    private fun argument(value: Any): String =
        if (value is Collection<*>) "listOf(${value.joinToString { kotlinOf(it as Any) }})" else kotlinOf(value)

    override fun breachIn(run: Run): Breach? = run.agents.mapNotNull { breachOf(run, it) }.minByOrNull { it.at }
}

/** Returns true if [command] is [pattern], or begins with it as its name: `drive` stands for `drive(3)`. */
internal fun isCommand(command: String, pattern: String) = command == pattern || command.startsWith("$pattern(")

internal fun List<String>.hasCommand(command: String) = any { isCommand(command, it) }

internal fun inMs(time: Duration) = "${time.inWholeMilliseconds} ms"
