package benchmarks

import argo.exploring.Found
import argo.exploring.Outcome
import argo.exploring.outcomeOf
import argo.exploring.reportOf
import planted.PLANTED
import planted.Planted
import java.nio.file.Path
import kotlin.io.path.createTempDirectory
import kotlin.time.Duration.Companion.seconds
import kotlin.time.DurationUnit
import kotlin.time.TimedValue
import kotlin.time.measureTimedValue

/**
 * Explores 25 agents with one planted fault each, and then the corrected agents. Returns true on two conditions. At least 20 faults are
 * found, each within 60 s and with at most five events. No corrected agent breaks a rule.
 */
internal fun explored(): Boolean {
    println("machine: ${machine()}")
    println(figures("%-14s %6s %6s %6s  %s", "agent", "s", "runs", "events", "rule that is broken"))
    val folder = createTempDirectory("argo-planted")
    val found = PLANTED.count { planted -> report(planted, search(planted, folder)) }
    val alarms = PLANTED.filter { planted -> isAlarm(planted, folder) }
    folder.toFile().deleteRecursively()
    println("$found of ${PLANTED.size} planted faults found within $LIMIT and shrunk to $MOST_EVENTS events or fewer")
    val breaking = alarms.joinToString().ifEmpty { "none" }
    println("${alarms.size} of ${PLANTED.size} mended agents break a rule in $MENDED_RUNS runs: $breaking")
    return alarms.isEmpty() && found >= ENOUGH
}

private fun search(planted: Planted, folder: Path): TimedValue<Outcome> = measureTimedValue {
    outcomeOf("${planted.write(folder, isMended = false)}") {
        planted.describe(this)
        time = LIMIT
    }
}

private fun report(planted: Planted, search: TimedValue<Outcome>): Boolean {
    val found = search.value as? Found
    val seconds = search.duration.toDouble(DurationUnit.SECONDS)
    val (events, rule) = if (found == null) "-" to "not found" else found.events.size to found.rule
    println(figures("%-14s %6.1f %6d %6s  %s", planted, seconds, search.value.runs, events, rule))
    return found != null && search.duration <= LIMIT && found.events.size <= MOST_EVENTS
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
