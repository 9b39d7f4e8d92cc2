package argo.testkit

import java.util.logging.Level
import kotlin.time.Duration.Companion.nanoseconds

/** The state of this agent, to show why an expectation is not met. */
internal fun TestAgent.report(): String {
    val found = listOf("sent" to accounted(), "believes" to beliefs, "intends" to intentions, "said" to said, "log" to newest(entries))
    val state = if (isRunning) "" else ", stopped"
    return found.joinToString("\n", "after $now$state\n") { (what, lines) ->
        "$what: ${if (lines.isEmpty()) "nothing" else lines.joinToString("\n    ", "\n    ")}"
    }
}

private fun TestAgent.accounted(): List<String> = platform.all().flatMap { it.accounted }
    .map { (command, isTaken) -> if (isTaken) "$command, taken by an earlier expectation" else command }

/** Errors stay, however old: a program that cannot be read is reported at the start. */
private fun newest(entries: List<AgentLog.Entry>): List<String> =
    entries.filterIndexed { i, entry -> entry.level == Level.SEVERE || i >= entries.size - LOGGED }
        .map { "at ${it.atNanos.nanoseconds}: $it" }

/** How many of the newest records of the log are shown. */
private const val LOGGED = 20
