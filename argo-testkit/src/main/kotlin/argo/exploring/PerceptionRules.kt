package argo.exploring

import argo.testkit.formula
import jason.asSemantics.Agent
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * No plan sends a command while a board's newest message is older than [maxAge].
 *
 * @param except commands that are allowed at any time, such as `stop`; `drive` also means `drive(3)`
 */
fun neverActsOnStalePercepts(maxAge: Duration = 1.seconds, except: List<String> = emptyList()): Rule =
    ReadyRule("neverActsOnStalePercepts", "never acts on stale percepts", maxAge, except) { run, agent ->
        actionOnStalePercepts(run.of(agent), maxAge, except)
    }

/**
 * An agent without percepts stops its motion. An agent becomes blind [blindAfter] after its newest message. The next message ends the
 * blindness. A blind agent sends none of [moving]. If one of [moving] was sent after the last [safe], the agent must send [safe] within the
 * time [within]. The time [within] starts when the agent becomes blind. If the agent's port was off, the time starts when the port is on
 * again.
 *
 * @param safe the command that stops the motion; `speed` also means `speed(0)`
 */
fun stopsWhenBlind(safe: String, moving: List<String>, blindAfter: Duration = 1.seconds, within: Duration = 1.seconds): Rule =
    ReadyRule("stopsWhenBlind", "stops when blind", safe, moving, blindAfter, within) { run, agent ->
        val messages = run.of(agent).filterIsInstance<Received>().map { it.at }
        messages.zip(messages.drop(1) + run.ended).filter { (last, next) -> next - last > blindAfter }
            .firstNotNullOfOrNull { (last, next) -> BlindTime(run, agent, last, next, last + blindAfter).breach(safe, moving, within) }
    }

/**
 * If [percept] starts to hold and holds for the time [within], the agent sends one of [commands] within that time. The time starts with the
 * last byte of the first message in which [percept] holds. If the agent's last command is already one of [commands], it need not send
 * another.
 *
 * @param percept a belief or a condition as in a plan's context: `dist(front,X) & X < 20`
 * @throws IllegalArgumentException if [percept] is neither a belief nor a condition
 */
fun reactsTo(percept: String, commands: List<String>, within: Duration = 1.seconds): Rule {
    val condition = PerceivedFormula(percept)
    return ReadyRule("reactsTo", "reacts to $percept", percept, commands, within) { run, agent ->
        val entries = run.of(agent)
        condition.periodsIn(entries).firstOrNull { (begins, ends) ->
            begins.received + within <= (ends?.received ?: run.ended) && !reacts(entries, begins.received, commands, within)
        }?.let { (begins) ->
            val received = begins.received
            Breach(received + within, "$agent has perceived $percept at ${inMs(received)} and sent none of ${commands.joinToString()}")
        }
    }
}

private fun reacts(entries: List<AgentEntry>, received: Duration, commands: List<String>, within: Duration): Boolean {
    val issued = entries.filterIsInstance<Issued>()
    val last = issued.lastOrNull { it.at <= received }
    return last != null && commands.hasCommand(last.command) ||
        issued.any { it.at in received..received + within && commands.hasCommand(it.command) }
}

/**
 * If [percept] has held for the time [after], plans send none of [commands] while it still holds.
 *
 * @param percept a belief or a condition as in a plan's context: `dist(front,X) & X < 20`
 * @throws IllegalArgumentException if [percept] is neither a belief nor a condition
 */
fun neverSends(commands: List<String>, percept: String, after: Duration = 1.seconds): Rule {
    val condition = PerceivedFormula(percept)
    val name = "never sends ${commands.joinToString()} while $percept"
    return ReadyRule("neverSends", name, commands, percept, after) { run, agent ->
        val sent = run.planned(agent).filter { commands.hasCommand(it.command) }
        condition.periodsIn(run.of(agent)).firstNotNullOfOrNull { (begins, ends) ->
            val since = begins.received
            sent.firstOrNull { it.at > since + after && (ends == null || it.at < ends.received) }
                ?.let { Breach(it.at, "$agent sends ${it.command} by ${it.plan}, though it has perceived $percept since ${inMs(since)}") }
        }
    }
}

/** An agent that has ever perceived something perceives again within the time [within] after the last event. */
fun perceivesAgain(within: Duration = 5.seconds): Rule = ReadyRule("perceivesAgain", "perceives again", within) { run, agent ->
    val quiet = run.events.maxOfOrNull { it.ends } ?: Duration.ZERO
    val last = run.of(agent).filterIsInstance<Perceived>().lastOrNull()
    if (last == null || quiet + within > run.ended || last.at >= quiet) null
    else Breach(quiet + within, "$agent has perceived nothing since ${inMs(last.at)}, though the last event ended at ${inMs(quiet)}")
}

private fun actionOnStalePercepts(entries: List<AgentEntry>, maxAge: Duration, except: List<String>): Breach? {
    val newest = LinkedHashMap<String, Duration>()
    for (entry in entries) {
        if (entry is Received) newest[entry.port] = entry.at
        if (entry !is Issued || entry.plan == null || except.hasCommand(entry.command)) continue
        val (port, received) = newest.minByOrNull { it.value } ?: continue
        val age = entry.at - received
        if (age <= maxAge) continue
        val known = "its newest percepts of $port are ${inMs(age)} old"
        return Breach(entry.at, "${entry.agent} sends ${entry.command} by ${entry.plan}, though $known")
    }
    return null
}

private class BlindTime(
    private val run: Run,
    private val agent: String,
    private val last: Duration,
    private val next: Duration,
    private val blind: Duration,
) {
    fun breach(safe: String, moving: List<String>, within: Duration): Breach? {
        fun isMoving(command: Issued) = moving.hasCommand(command.command)
        val entries = run.of(agent)
        val commands = run.planned(agent).filter { isMoving(it) || isCommand(it.command, safe) }
        commands.firstOrNull { isMoving(it) && it.at > blind && it.at < next }
            ?.let { return Breach(it.at, "$agent sends ${it.command} by ${it.plan}, though it has perceived nothing since ${inMs(last)}") }
        if (next <= blind + within) return null
        val before = commands.lastOrNull { it.at <= blind }?.takeIf(::isMoving) ?: return null
        val off = entries.any { it is PortChanged && it.status == "off" && it.at in last..next }
        val seeingAgain = entries.firstOrNull { it is PortChanged && it.status == "on" && it.at > last }?.at
        val deadline = (if (off) seeingAgain ?: return null else blind) + within
        if (deadline > run.ended || commands.any { isCommand(it.command, safe) && it.at in before.at..deadline }) return null
        val sent = "$agent has sent ${before.command} at ${inMs(before.at)}"
        return Breach(deadline, "$sent, has perceived nothing since ${inMs(last)}, and has not sent $safe")
    }
}

private class PerceivedFormula(text: String) {
    private val formula = formula(text)

    /**
     * Returns the periods in which the condition holds. A period is its first message and the first message behind it, or null at the end
     * of the run.
     */
    fun periodsIn(entries: List<AgentEntry>): List<Pair<Perceived, Perceived?>> {
        val believer = Agent().apply { initAg() }
        val periods = ArrayList<Pair<Perceived, Perceived?>>()
        for (message in entries.filterIsInstance<Perceived>()) {
            val holds = believer.holds(message.percepts)
            val isOpen = periods.isNotEmpty() && periods.last().second == null
            if (holds && !isOpen) periods += message to null
            if (!holds && isOpen) periods[periods.lastIndex] = periods.last().first to message
        }
        return periods
    }

    private fun Agent.holds(percepts: List<String>): Boolean {
        bb.clear()
        percepts.forEach { runCatching { bb.add(ASSyntax.parseLiteral(it)) } } // skips unreadable percepts, as the agent does
        return formula.logicalConsequence(this, Unifier()).hasNext()
    }
}
