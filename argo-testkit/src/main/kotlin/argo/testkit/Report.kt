package argo.testkit

import argo.Arch
import argo.observing.ObservedAgent
import argo.perception.whyLeftOut
import java.util.logging.Level
import kotlin.time.Duration.Companion.nanoseconds

internal fun TestAgent.report(): String {
    val found = listOf(
        "sent" to accounted(), "boards" to boards(), "believes" to beliefs, "intends" to intentions, "said" to said,
        (if (entries.size > LOGGED) "log, the newest $LOGGED lines and the errors of ${entries.size}" else "log") to newest(entries),
    )
    val state = if (isRunning) "" else ", stopped"
    return found.joinToString("\n", "after ${now.inWholeMilliseconds} ms$state\n") { (what, lines) ->
        "$what: ${if (lines.isEmpty()) "nothing" else lines.joinToString("\n    ", "\n    ")}"
    }
}

internal val TestAgent.isPerceiving: Boolean get() = observed()?.isPerceiving ?: false

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

/** Describes the percepts of the agent's boards, the effect of filters on them, and whether the agent perceives the boards. */
private fun TestAgent.boards(): List<String> {
    val agent = observed() ?: return emptyList()
    val ports = agent.ports().associateBy { it.name.removeSurrounding("\"") } // these names are in Jason's syntax, with quotes
    val blocked = if (agent.isPerceiving) emptyList() else listOf("perceiving is blocked: the agent starts it with argo.percepts(open)")
    return blocked + platform.named().flatMap { (name, board) ->
        val port = ports[name]
        val state = listOfNotNull(port?.status ?: "never opened", "not perceived".takeIf { port?.isPerceived == false })
        val shown = board.shown
        val fates = shown.orEmpty().take(MOST_PERCEPTS).mapNotNull { fate(agent, it, port?.filter != null) }
        val rest = if (shown.orEmpty().size > MOST_PERCEPTS) listOf("  what becomes of the others is not described") else emptyList()
        listOf("$name (${state.joinToString()}) shows ${shown?.joinToString()?.ifEmpty { null } ?: "nothing"}") +
            fates.map { "  $it" } + rest
    }
}

private fun TestAgent.fate(agent: ObservedAgent, percept: String, isFiltered: Boolean): String? {
    val fault = whyLeftOut(percept.trim())
    return when {
        fault != null -> "$percept is left out: $fault"
        isFiltered -> mas.time.driving { agent.explain(percept) }
        else -> null
    }
}

private const val MOST_PERCEPTS = 24

private fun TestAgent.observed(): ObservedAgent? =
    generateSequence(ts.agArch) { it.nextAgArch }.filterIsInstance<Arch>().firstOrNull()?.observed

private fun TestAgent.accounted(): List<String> = platform.all().flatMap { it.accounted }.sortedBy { (arrival, _) -> arrival.at }
    .map { (arrival, isTaken) ->
        "at ${arrival.at.inWholeMilliseconds} ms: ${arrival.command}${if (isTaken) ", taken by an earlier expectation" else ""}"
    }

/** Selects the newest entries and all errors. An unreadable program is reported at the start, so its error may be old. */
private fun newest(entries: List<AgentLog.Entry>): List<String> =
    entries.filterIndexed { i, entry -> entry.level == Level.SEVERE || i >= entries.size - LOGGED }
        .map { "at ${it.atNanos.nanoseconds.inWholeMilliseconds} ms: $it" }

private const val LOGGED = 20
