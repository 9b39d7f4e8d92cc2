package argo.exploring

import kotlin.time.TimeSource

/**
 * Looks for a run of the agents in [source] in which they break a rule. The real agents run in virtual time, against changing sensors,
 * faults of boards and lines, and messages. A seed draws these events.
 *
 *     test("nothing that happens to its board confuses the robot") {
 *         explore("robot.asl") {
 *             board("ttyACM0") { sensor("dist(front,%d)", 5..200) }
 *             rules(usualRules() + stopsWhenBlind("stop", moving = listOf("front")))
 *         }
 *     }
 *
 * Tries [Exploration.runs] runs, but for no longer than [Exploration.time] in real time.
 *
 * @param source the file of an agent, or the `.mas2j` of a system; looked for as the test kit's `agent` does
 * @return the number and the time of the runs, if all rules were kept
 * @throws AssertionError if a rule is broken, or if the agents are not deterministic. The message for a broken rule contains the shortened
 *   run in words and as a spec.
 * @throws IllegalArgumentException if there is no such file, Jason cannot read it, no board is described, or no agent opens a described
 *   board
 */
fun explore(source: String, describe: Exploration.() -> Unit): NothingFound =
    when (val outcome = outcomeOf(source, describe)) {
        is NothingFound -> outcome
        else -> throw AssertionError(reportOf(outcome))
    }

/** Returns the outcome of [explore] instead of throwing an [AssertionError]. */
fun outcomeOf(source: String, describe: Exploration.() -> Unit): Outcome = Search(scenario(source, describe), TimeSource.Monotonic).look()

/**
 * Plays [events] against the agents in [source], once, and returns the run. The same events give the same run.
 *
 * @throws IllegalArgumentException if there is no such file, Jason cannot read it, or no board is described. An event about a missing
 *   board, sensor or agent is refused too.
 */
fun runOf(source: String, events: List<WorldEvent>, describe: Exploration.() -> Unit): Run = scenario(source, describe).playWritten(events)

/**
 * Plays [events] against the agents in [source] and checks the rules: the spec that [explore] prints calls it.
 *
 * @throws AssertionError if a rule is broken
 * @throws IllegalArgumentException like [runOf]
 */
fun shouldKeepRules(source: String, vararg events: WorldEvent, describe: Exploration.() -> Unit): Run {
    val scenario = scenario(source, describe)
    val run = scenario.playWritten(events.toList())
    val (rule, breach) = scenario.breachIn(run) ?: return run
    throw AssertionError("the rule \"${rule.name}\" is broken after ${inMs(breach.at)}: ${breach.how}\n${storyOf(run)}")
}

private fun scenario(source: String, describe: Exploration.() -> Unit) =
    Scenario(programIn(source), source, Exploration().apply(describe).checked())
