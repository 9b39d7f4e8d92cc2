package argo.exploring

import kotlin.time.Duration

/**
 * A condition that must hold in each run. A project can write its own rules:
 *
 *     val neverReverses = rule("never reverses") { run ->
 *         run.trace.filterIsInstance<Issued>().firstOrNull { it.command == "back" }?.let { Breach(it.at, "it reversed") }
 *     }
 *
 * The result must depend only on the run.
 */
fun interface Rule {
    /** Returns the first breach of this rule in [run], or null if there is none. */
    fun breachIn(run: Run): Breach?

    /** A short form of the condition. */
    val name: String get() = javaClass.simpleName
}

/** A breach of a rule: its time and a description. */
data class Breach(val at: Duration, val how: String)

/** Makes a rule with this [name]. */
fun rule(name: String, breachIn: (Run) -> Breach?): Rule = object : Rule {
    override val name = name

    override fun breachIn(run: Run) = breachIn(run)

    override fun toString() = name
}

/**
 * A rule of this package. `toString` returns the Kotlin call for this rule. [breachOf] returns the first breach of an agent in a run, or
 * null if there is none.
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

internal fun isCommand(command: String, pattern: String) = command == pattern || command.startsWith("$pattern(")

internal fun List<String>.hasCommand(command: String) = any { isCommand(command, it) }

internal fun inMs(time: Duration) = "${time.inWholeMilliseconds} ms"
