package argo.exploring

import kotlin.time.TimeSource

/**
 * Searches for a run in which agents in [source] break a rule. The real agents run in virtual time. During a run, sensors change, boards
 * and lines fail, and messages arrive. A seed determines these events.
 *
 *     test("nothing that happens to its board confuses the robot") {
 *         explore("robot.asl") {
 *             board("ttyACM0") { sensor("dist(front,%d)", 5..200) }
 *             rules(usualRules() + stopsWhenBlind("stop", moving = listOf("front")))
 *         }
 *     }
 *
 * Stops after [Exploration.runs] runs, or after [Exploration.time] of real time.
 *
 * @param source the file of an agent, or the `.mas2j` of a system. The test kit's `agent` tells where the file is searched
 * @return the number of runs and their total time, if no run broke a rule
 * @throws AssertionError if a rule is broken, or if the agents are not deterministic. The message for a broken rule contains the shortened
 * run in words and as a spec
 * @throws IllegalArgumentException if the file does not exist or cannot be read, if no board is described, or if no agent opens a described
 * board
 */
fun explore(source: String, describe: Exploration.() -> Unit): NothingFound =
    when (val outcome = outcomeOf(source, describe)) {
        is NothingFound -> outcome
        else -> throw AssertionError(reportOf(outcome))
    }

/** Returns the outcome of [explore]. Throws no [AssertionError]. */
fun outcomeOf(source: String, describe: Exploration.() -> Unit): Outcome = Search(scenario(source, describe), TimeSource.Monotonic).look()

/**
 * Runs the agents in [source] once with [events]. Equal events give equal runs.
 *
 * @throws IllegalArgumentException if the file does not exist or cannot be read, if no board is described, or if an event names a missing
 * board, sensor or agent
 */
fun runOf(source: String, events: List<WorldEvent>, describe: Exploration.() -> Unit): Run = scenario(source, describe).playWritten(events)

/**
 * Runs the agents in [source] with [events], and checks the rules. Specs that [explore] prints call this function.
 *
 * @throws AssertionError if a rule is broken
 * @throws IllegalArgumentException as [runOf] does
 */
fun shouldKeepRules(source: String, vararg events: WorldEvent, describe: Exploration.() -> Unit): Run {
    val scenario = scenario(source, describe)
    val run = scenario.playWritten(events.toList())
    val (rule, breach) = scenario.breachIn(run) ?: return run
    throw AssertionError("the rule \"${rule.name}\" is broken after ${inMs(breach.at)}: ${breach.how}\n${storyOf(run)}")
}

private fun scenario(source: String, describe: Exploration.() -> Unit) =
    Scenario(programIn(source), source, Exploration().apply(describe).checked())
