package experiment.report

import experiment.Condition
import experiment.Finished
import experiment.Outcome
import experiment.Plan
import experiment.View
import experiment.exchangeNanos
import experiment.leastStopNanos
import experiment.leavesTime
import experiment.limitNanos
import kotlin.math.abs

/** The result of the runs for a published or promised claim. */
internal enum class Finding(val word: String) { YES("found"), PARTLY("in part"), NO("not found"), UNTESTED("not tested") }

/** A published result or a promise, and the result [seen] in the runs. [why] explains the claim. */
internal class Claim(val claim: String, val finding: Finding, val seen: String, val why: String)

private fun List<Finished>.of(view: View, vararg limits: Int) = filter {
    it.trial.view == view && (limits.isEmpty() || it.trial.limit in limits)
}
private fun List<Finished>.stopped() = count { it.result.outcome == Outcome.STOPPED }
private fun List<Finished>.sinceLimit() = filter { it.result.outcome == Outcome.STOPPED }.map { it.result.sinceLimitMs / 1000 }

/**
 * Writes a text such as `, 350 ms after the limit and 180 ms after the agent perceived the wall (medians)`. The text is empty if no robot
 * has stopped.
 */
private fun List<Finished>.medians(): String {
    if (stopped() == 0) return ""
    val perceived = median(filter { it.result.outcome == Outcome.STOPPED }.map { (it.result.sincePerceivingMs ?: 0.0) / 1000 })
    val order = if (perceived < 0) "before" else "after"
    return ", ${time(median(sinceLimit()))} after the limit and ${time(abs(perceived))} $order the agent perceived the wall (medians)"
}

private fun finding(found: Int, of: Int) = if (found == of) Finding.YES else if (found > 0) Finding.PARTLY else Finding.NO

/** Compares the published results with the [runs] of the published condition. Claims about levels that are not in [plan] are not tested. */
internal fun publishedClaims(runs: List<Finished>, plan: Plan, analysis: Factorial?): List<Claim> {
    val published = runs.filter { it.trial.condition == Condition.PUBLISHED }
    if (published.isEmpty()) return emptyList()
    return listOfNotNull(
        unfiltered(published), frontDistance(published), frontSide(published), shortest(published, plan), allocation(analysis),
    )
}

private fun unfiltered(runs: List<Finished>): Claim? {
    val none = runs.of(View.NONE).ifEmpty { return null }
    return Claim(
        "Without a filter the robot hits the wall in all cases.",
        finding(none.size - none.stopped(), none.size),
        "${none.size - none.stopped()} of ${none.size} runs ended at the wall.",
        "Each frame changes twelve percepts, so it adds twelve events. Jason handles one event in a reasoning cycle, and in this " +
            "condition each cycle waits for a whole exchange with the board. The step of the driving goal that would stop the robot is " +
            "an event too and waits behind all the others.",
    )
}

private fun frontDistance(runs: List<Finished>): Claim? {
    val front = runs.of(View.FRONT_DISTANCE, 80, 120).ifEmpty { return null }
    return Claim(
        "With the front distance filter it stops in every run at limits of 80 and 120 cm.",
        finding(front.stopped(), front.size),
        "${front.stopped()} of ${front.size} runs stopped${front.medians()}.",
        "A frame adds one event, and a cycle handles one.",
    )
}

private fun frontSide(runs: List<Finished>): Claim? {
    val side = runs.of(View.FRONT_SIDE, 120).ifEmpty { return null }
    val nearer = side.filter { it.result.outcome == Outcome.STOPPED }.map { it.result.distance }
    val front = runs.of(View.FRONT_DISTANCE, 120).map { it.result.distance }.ifEmpty { return null }
    val where = if (nearer.isEmpty()) ""
    else ", ${one(nearer.average())} cm from the wall on average (front distance: ${one(front.average())} cm)"
    return Claim(
        "With the front side filter it stops sometimes at 120 cm, always nearer to the wall.",
        when {
            side.stopped() == 0 || nearer.max() >= front.min() -> Finding.NO
            side.stopped() < side.size -> Finding.YES
            else -> Finding.PARTLY
        },
        "${side.stopped()} of ${side.size} runs at 120 cm stopped$where; of all limits ${runs.of(View.FRONT_SIDE).stopped()} of " +
            "${runs.of(View.FRONT_SIDE).size}.",
        "Three events a frame and one handled: the queue grows by two each cycle, so each step of the driving goal waits three times " +
            "as long as the one before. The steps come so far apart that the start of the agent decides whether one of them " +
            "falls between the limit and the wall. " +
            "That instant depends on the speed of the computer, which is an assumption here.",
    )
}

private fun shortest(runs: List<Finished>, plan: Plan): Claim? {
    val claim = "At a limit of 40 cm and an interval of 50 ms neither filter avoids the wall (Figure 8 of the paper)."
    if (40 !in plan.limits || 50 !in plan.intervals) {
        return Claim(claim, Finding.UNTESTED, "These runs have no such limit or interval.", "The full plan has them.")
    }
    val cell = runs.filter { it.trial.limit == 40 && it.trial.interval == 50 && it.trial.view != View.NONE }.ifEmpty { return null }
    val hit = cell.size - cell.stopped()
    val front = cell.of(View.FRONT_DISTANCE)
    return Claim(
        claim,
        finding(hit, cell.size),
        "$hit of ${cell.size} such runs ended at the wall; with front distance ${front.stopped()} of ${front.size} " +
            "stopped${front.medians()}.",
        "40 cm leave 4 s at 10 cm/s. The model's sensors take no time to be read, its board runs nothing else, and its robot stops at " +
            "once; a real one spends time on each of these, and the paper does not say how much. A request and its answer take " +
            "${exchangeNanos(cell.first().trial) / 1_000_000} ms at 9600 baud, more than any of the intervals, so the interval cannot " +
            "matter on this line.",
    )
}

private fun allocation(analysis: Factorial?): Claim? {
    if (analysis == null) return null
    val share = 100 * analysis.share(Source.C)
    val others = Source.entries.filter { it != Source.C }.maxOf { 100 * analysis.share(it) }
    return Claim(
        "The filter explains by far the most of the variation of the time from perceiving the wall: " +
            "${Published.percent.getValue(Source.C)} % (Table 2 of the paper).",
        if (share > 4 * others && share > 50) Finding.YES else if (share > others) Finding.PARTLY else Finding.NO,
        "${one(share)} %; the next largest share is ${one(others)} %.",
        "The filter decides above all whether a robot stops at all. The shares of the limit and of L×F depend on how collisions enter: " +
            "see the tables. The published shares add up to ${rounded(Published.sumPercent, 2)} %, so one of them at least is not exact.",
    )
}

/** Compares this project's promise for [condition] with [runs]. Returns null if no run has this condition. */
internal fun promise(runs: List<Finished>, condition: Condition): Claim? {
    val own = runs.filter { it.trial.condition == condition && leavesTime(it.trial) }.ifEmpty { return null }
    val none = own.of(View.NONE)
    val slowest = own.maxBy { leastStopNanos(it.trial) }.trial
    val worst = none.sinceLimit().maxOrNull()?.let { "; ${time(it)} after the limit at most" }.orEmpty()
    return Claim(
        "(${condition.letter}) ${condition.title}: every run stops if its limit leaves enough physical time, also without a filter.",
        finding(own.stopped(), own.size),
        "${own.stopped()} of ${own.size} runs stopped; without a filter ${none.stopped()} of ${none.size}${none.medians()}$worst.",
        why(condition) + ", ${leastStopNanos(slowest) / 1_000_000} ms at most here. The shortest limit leaves " +
            "${time(own.minOf { limitNanos(it.trial) } / 1e9)}, " +
            "so ${if (own.size == runs.count { it.trial.condition == condition }) "all runs have it" else "${own.size} runs have it"}.",
    )
}

private fun why(condition: Condition) = if (condition == Condition.REFLEX)
    "The board reads its sensors every 5 ms and stops the robot itself. A command to drive that was on its way makes the robot drive on, " +
        "until the board stops it again, or the agent, which the board informs at once; the last stop counts. The physical time " +
        "is the noise of the reading, and the next reading after a frame that the board is sending"
else "The agent gets the newest frame, and gets it when it has handled the events of the one before and its commands are out: it " +
    "never acts on one older than a few exchanges. The physical time is the longest that line and sensors take, whatever " +
    "program drives the robot: the noise of the reading, an exchange that began just before the limit, the next one and the command"

internal fun median(values: List<Double>): Double = values.sorted().let { (it[(it.size - 1) / 2] + it[it.size / 2]) / 2 }
