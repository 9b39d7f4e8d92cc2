package benchmarks

import argo.exploring.Found
import argo.exploring.Outcome
import argo.exploring.outcomeOf
import argo.exploring.reportOf
import planted.PLANTED
import planted.Planted
import java.nio.file.Path
import kotlin.io.path.createTempDirectory
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds
import kotlin.time.DurationUnit
import kotlin.time.TimeSource

/**
 * Explores 25 agents with one planted fault each, and then the corrected agents. Returns true on two conditions. At least 20 faults are
 * found, each within 60 s and with at most five events. No corrected agent breaks a rule. If [only] is given, explores only that agent. The
 * fault of [only] need not be found.
 */
internal fun explored(only: String? = null): Boolean {
    println("machine: ${machine()}")
    println(figures("%-14s %6s %6s %6s  %s", "agent", "s", "runs", "events", "rule that is broken"))
    val folder = createTempDirectory("argo-planted")
    val agents = PLANTED.filter { only == null || it.name == only }
    val found = agents.count { planted -> report(planted, search(planted, folder)) }
    val alarms = agents.filter { planted -> isAlarm(planted, folder) }
    folder.toFile().deleteRecursively()
    println("$found of ${agents.size} planted faults found within $LIMIT and shrunk to $MOST_EVENTS events or fewer")
    println("${alarms.size} of ${agents.size} mended agents break a rule in $MENDED_RUNS runs: ${alarms.joinToString().ifEmpty { "none" }}")
    return alarms.isEmpty() && (only != null || found >= ENOUGH)
}

private class Timed(val outcome: Outcome, val took: Duration)

private fun search(planted: Planted, folder: Path): Timed {
    val begun = TimeSource.Monotonic.markNow()
    val outcome = outcomeOf("${planted.write(folder, isMended = false)}") {
        planted.describe(this)
        time = LIMIT
    }
    return Timed(outcome, begun.elapsedNow())
}

private fun report(planted: Planted, search: Timed): Boolean {
    val found = search.outcome as? Found
    val seconds = search.took.toDouble(DurationUnit.SECONDS)
    val (events, rule) = if (found == null) "-" to "not found" else found.events.size to found.rule
    println(figures("%-14s %6.1f %6d %6s  %s", planted, seconds, search.outcome.runs, events, rule))
    return found != null && search.took <= LIMIT && found.events.size <= MOST_EVENTS
}

private fun isAlarm(planted: Planted, folder: Path): Boolean {
    val outcome = outcomeOf("${planted.write(folder, isMended = true)}") {
        planted.describe(this)
        runs = MENDED_RUNS
    }
    if (outcome is Found) println("mended $planted:\n${reportOf(outcome)}")
    return outcome is Found
}

private val LIMIT = 60.seconds
private const val MOST_EVENTS = 5
private const val MENDED_RUNS = 100
private const val ENOUGH = 20
