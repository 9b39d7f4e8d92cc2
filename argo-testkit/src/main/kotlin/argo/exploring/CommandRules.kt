package argo.exploring

import argo.testkit.literalIn
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * No command is lost unnoticed. Each command has an outcome within the time [within]. After a failure, the agent sends a command, prints
 * something or sends a message, also within [within]. A command that was replaced by a later one does not count as failed.
 */
fun losesNoCommand(within: Duration = 5.seconds): Rule = ReadyRule("losesNoCommand", "loses no command", within) { run, agent ->
    val entries = run.of(agent)
    listOfNotNull(unfinished(entries, run.ended, within), unnoticed(entries, run.ended, within)).minByOrNull { it.at }
}

/**
 * If one of [commands] fails, the agent sends one of [commands] again. The agent sends it within the time [within], counted from its next
 * perception of the board. The rule applies only while the percepts of the first command stay unchanged. Without this rule, an agent may
 * believe that it has stopped while it drives on.
 */
fun sendsAgain(commands: List<String>, within: Duration = 3.seconds): Rule =
    ReadyRule("sendsAgain", "sends ${commands.joinToString(" or ")} again", commands, within) { run, agent ->
        val entries = run.of(agent)
        val sent = entries.filterIsInstance<Issued>().filter { commands.hasCommand(it.command) }
        entries.filterIsInstance<Ended>().filter { it.error != null && it.error !in FINAL }.mapNotNull { lost ->
            val command = sent.find { it.number == lost.number } ?: return@mapNotNull null
            val limit = wantedUntil(entries.filterIsInstance<Perceived>().filter { it.port == command.port }, command, lost, within)
            if (limit == null || limit > run.ended || sent.any { it.number > command.number && it.at <= limit }) null
            else Breach(limit, "${command.command} of $agent failed with ${lost.error} at ${inMs(lost.at)}, and is not sent again")
        }.minByOrNull { it.at }
    }

/** The plans of an agent send at most [most] commands in any second. */
fun neverFloods(most: Int = 20): Rule = ReadyRule("neverFloods", "never floods", most) { run, agent ->
    run.planned(agent).map { it.at }.windowed(most + 1).firstOrNull { it.last() - it.first() < 1.seconds }
        ?.let { Breach(it.last(), "$agent sends ${it.size} commands between ${inMs(it.first())} and ${inMs(it.last())}") }
}

/**
 * An agent does not alternate between two commands. In any second, it changes back at most [most] times. The commands A, B, A are one
 * change back.
 */
fun neverOscillates(most: Int = 3): Rule = ReadyRule("neverOscillates", "never oscillates", most) { run, agent ->
    run.planned(agent).windowed(3).filter { (a, b, c) -> a.command == c.command && a.command != b.command }
        .windowed(most + 1).firstOrNull { it.last().last().at - it.first().first().at < 1.seconds }
        ?.let { changes ->
            val (one, other) = changes.first()
            val ends = changes.last().last().at
            val often = "${changes.size} times between ${one.command} and ${other.command}"
            Breach(ends, "$agent changes $often, from ${inMs(one.at)} to ${inMs(ends)}")
        }
}

/**
 * Agents send only these [actions]: `ledOn`, `speed/1`, or `say/` and a star for any number of arguments. The notation is that of the test
 * kit's `knows`.
 */
fun sendsOnly(actions: List<String>): Rule = ReadyRule("sendsOnly", "sends only known commands", actions) { run, agent ->
    run.planned(agent).firstOrNull { !isKnown(it.command, actions) }
        ?.let { Breach(it.at, "$agent sends ${it.command} by ${it.plan}; the board knows ${actions.joinToString()}") }
}

/** An agent that has sent commands sends another one within the time [within] after the last event. */
fun actsAgain(within: Duration = 5.seconds): Rule = ReadyRule("actsAgain", "acts again", within) { run, agent ->
    val quiet = run.events.maxOfOrNull { it.ends } ?: Duration.ZERO
    val last = run.planned(agent).lastOrNull()
    if (last == null || quiet + within > run.ended || last.at >= quiet) null
    else Breach(quiet + within, "$agent has sent no command since ${inMs(last.at)}, though the last event ended at ${inMs(quiet)}")
}

private fun unfinished(entries: List<AgentEntry>, ended: Duration, within: Duration): Breach? {
    val outcomes = entries.filterIsInstance<Ended>().associateBy { it.number }
    return entries.filterIsInstance<Issued>().firstNotNullOfOrNull { command ->
        val late = (outcomes[command.number]?.at ?: ended) - command.at
        if (late <= within) null
        else Breach(command.at + within, "${command.command}, which ${command.agent} sent at ${inMs(command.at)}, has no outcome")
    }
}

private fun unnoticed(entries: List<AgentEntry>, ended: Duration, within: Duration): Breach? =
    entries.filterIsInstance<Ended>().filter { it.error != null && it.error != "act_replaced" && it.at + within <= ended }
        .firstNotNullOfOrNull { lost ->
            val isNoticed = entries.any {
                it.at in lost.at..lost.at + within && (it is Issued && it.number > lost.number || it is Printed || it is Said)
            }
            if (isNoticed) null
            else Breach(lost.at + within, "${lost.command} of ${lost.agent} failed with ${lost.error}, and the agent does nothing about it")
        }

/** Errors after which an agent need not send the command again. */
private val FINAL = setOf("act_replaced", "act_refused")

private fun wantedUntil(perceived: List<Perceived>, command: Issued, lost: Ended, within: Duration): Duration? {
    val reason = perceived.lastOrNull { it.at <= command.at } ?: return null
    val again = perceived.firstOrNull { it.received > lost.at } ?: return null
    val limit = again.at + within
    val meanwhile = perceived.filter { it.at > command.at && it.at <= limit }
    return limit.takeIf { meanwhile.all { it.percepts.toSet() == reason.percepts.toSet() } }
}

private fun isKnown(command: String, actions: List<String>): Boolean {
    val (name, count) = literalIn(command)?.let { it.functor to it.arity } ?: (command to 0)
    return "$name/$count" in actions || "$name/*" in actions || count == 0 && name in actions
}

internal fun Run.planned(agent: String) = of(agent).filterIsInstance<Issued>().filter { it.plan != null }
