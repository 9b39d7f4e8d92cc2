package argo.testkit

import argo.Arch
import argo.observing.ObservedAgent
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

/** Whether this agent perceives through the port in use. */
internal val TestAgent.isPerceiving: Boolean get() = observed()?.isPerceiving ?: false

/** Why this agent has not perceived its first board. */
internal fun TestAgent.whyBlind(): String {
    val agent = observed()
    val port = agent?.ports()?.find { it.isInUse }
    return when {
        !isRunning -> "it is stopped"
        agent == null -> "it has no board, since its architecture is not argo.Arch"
        port == null -> "no port is in use; the agent chooses one with argo.port"
        !agent.isPerceiving -> "perceiving is blocked; the agent starts it with argo.percepts(open)"
        !board.isOpen -> "the port of that board is not open; port ${port.name} is in use"
        else ->
            "its board has answered no request for percepts; port ${port.name} is ${port.status}, the sensing interval is " +
                "${agent.intervalMs} ms, and a port with mode(listen) is not asked: there the board says(…) its percepts"
    }
}

private fun TestAgent.observed(): ObservedAgent? =
    generateSequence(ts.agArch) { it.nextAgArch }.filterIsInstance<Arch>().firstOrNull()?.observed

private fun TestAgent.accounted(): List<String> = platform.all().flatMap { it.accounted }
    .map { (command, isTaken) -> if (isTaken) "$command, taken by an earlier expectation" else command }

/** Errors stay, however old: a program that cannot be read is reported at the start. */
private fun newest(entries: List<AgentLog.Entry>): List<String> =
    entries.filterIndexed { i, entry -> entry.level == Level.SEVERE || i >= entries.size - LOGGED }
        .map { "at ${it.atNanos.nanoseconds}: $it" }

/** How many of the newest records of the log are shown. */
private const val LOGGED = 20
