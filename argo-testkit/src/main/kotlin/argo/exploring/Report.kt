package argo.exploring

import kotlin.time.Duration

/** Describes the outcome of an exploration in words. */
fun reportOf(outcome: Outcome): String = when (outcome) {
    is NothingFound -> "no rule was broken in ${runsOf(outcome)}"
    is NotDeterministic ->
        "the agents are not deterministic: the same events gave two different runs, so no run can be repeated.\n" +
            "first difference: ${outcome.difference}\n" +
            "Look for .random, math.random, .time, .date, threads of internal actions and environments, and the order of sets in Java.\n" +
            "the events:\n${wordsOf(outcome.events)}"
    is Found ->
        "the rule \"${outcome.rule}\" is broken after ${inMs(outcome.breach.at)}: ${outcome.breach.how}\n\n" +
            "what has to happen for it (${shrunk(outcome)}):\n${wordsOf(outcome.events)}\n\n" +
            "what the agents did:\n${storyOf(outcome.run)}\n\n" +
            "as a spec, which fails until it is mended:\n\n${specOf(outcome)}"
}

private fun shrunk(found: Found): String {
    val origin = found.seed?.let { "seed $it, ${found.drawn} events made ${found.events.size}" } ?: "no event is needed"
    return "$origin, ${runsOf(found)}"
}

private fun runsOf(outcome: Outcome) =
    (if (outcome.runs == 1) "1 run" else "${outcome.runs} runs") +
        ", ${outcome.played.inWholeMinutes} min ${outcome.played.inWholeSeconds % SECONDS} s of virtual time"

fun wordsOf(events: List<WorldEvent>): String =
    if (events.isEmpty()) "  nothing" else events.joinToString("\n") { "  ${timeOf(it.at)}  ${it.words}" }

/** Lists the events of the world and of the agents in [run], one on each line. Lists only the last [MOST_LINES]. */
internal fun storyOf(run: Run): String {
    val lines = run.trace.mapNotNull { entry -> lineOf(entry)?.let { "  ${timeOf(entry.at)}  $it" } }
    val left = if (lines.size > MOST_LINES) listOf("  … ${lines.size - MOST_LINES} more before these") else emptyList()
    return (left + lines.takeLast(MOST_LINES)).joinToString("\n")
}

private fun lineOf(entry: TraceEntry): String? = when (entry) {
    is Happened -> "* ${entry.event.words}"
    is Issued -> "${entry.agent} sends ${entry.command} to ${entry.port}${entry.plan?.let { " by $it" } ?: ", a reflex"}"
    is Ended -> entry.error?.let { "${entry.agent}: ${entry.command} failed with $it" }
    is PortChanged -> "${entry.agent}: port ${entry.port} is ${entry.status}"
    is Printed -> "${entry.agent} prints ${entry.text}"
    is Said -> "${entry.agent} says ${entry.message}"
    is FailedUnhandled -> "${entry.agent}: ${entry.what}"
    is Waits -> "${entry.agent} has waited since ${inMs(entry.since)} with ${entry.intention}"
    is Stopped -> "${entry.agent} is stopped"
    is NeverRests -> entry.what
    is Received, is Perceived, is MindSize -> null
}

private fun timeOf(at: Duration): String = inMs(at).padStart(COLUMN)

private const val MOST_LINES = 40
private const val COLUMN = 9
private const val SECONDS = 60
