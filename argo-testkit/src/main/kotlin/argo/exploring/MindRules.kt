package argo.exploring

import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * At the end of a run, no intention has waited for more than [longest] at a step without a time limit. The step `.wait(9000)` has a time
 * limit.
 *
 * @param except goals that may wait longer; `patrol` also means `patrol(3)`
 */
fun neverWaitsForever(longest: Duration = 6.seconds, except: List<String> = emptyList()): Rule =
    ReadyRule("neverWaitsForever", "never waits for ever", longest, except) { run, agent ->
        run.of(agent).filterIsInstance<Waits>()
            .filter { it.at - it.since > longest && except.none { goal -> isCommand(it.goal, goal) } }.minByOrNull { it.since }
            ?.let { Breach(it.since + longest, "$agent has waited since ${inMs(it.since)} with ${it.intention}") }
    }

private val Waits.goal get() = intention.substringBefore(" at ").trimStart('+', '-', '!')

/** For each plan that fails, another plan handles the failure. */
fun handlesFailures(): Rule = ReadyRule("handlesFailures", "handles failures") { run, agent ->
    run.of(agent).filterIsInstance<FailedUnhandled>().firstOrNull()?.let { Breach(it.at, "$agent: ${it.what}") }
}

/** After each reasoning cycle, an agent has at most [intentions] intentions, [beliefs] beliefs and [events] waiting events. */
fun staysSmall(intentions: Int = 20, beliefs: Int = 200, events: Int = 50): Rule =
    ReadyRule("staysSmall", "stays small", intentions, beliefs, events) { run, agent ->
        run.of(agent).filterIsInstance<MindSize>()
            .firstOrNull { it.intentions > intentions || it.beliefs > beliefs || it.events > events }
            ?.let { Breach(it.at, "$agent has ${it.intentions} intentions, ${it.beliefs} beliefs and ${it.events} events that wait") }
    }

/** Agents do not stop, and do not reason without end. Agents must rest, since only then virtual time advances. */
fun staysAlive(): Rule = ReadyRule("staysAlive", "stays alive") { run, agent ->
    run.trace.firstOrNull { it is NeverRests || it is Stopped && it.agent == agent }
        ?.let { Breach(it.at, if (it is NeverRests) it.what else "$agent is stopped") }
}

/** The rules that fit any agent. [explore] checks these rules by default. */
fun usualRules(): List<Rule> = listOf(
    staysAlive(), handlesFailures(), losesNoCommand(), neverWaitsForever(), staysSmall(), neverFloods(), neverOscillates(),
    perceivesAgain(),
)
