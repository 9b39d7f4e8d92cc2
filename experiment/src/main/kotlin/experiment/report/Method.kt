package experiment.report

import experiment.Condition
import experiment.Finished
import experiment.MAX_TRIES
import experiment.Plan
import experiment.RealLaboratory
import experiment.Settings
import experiment.Trial
import experiment.View
import experiment.exchangeNanos
import experiment.isLate
import experiment.maxLateMs
import samples.collision.Course
import samples.collision.Sensors
import java.time.Instant
import java.time.temporal.ChronoUnit

/**
 * The origin of a report.
 *
 * @property build the version and the commit of ARGO
 * @property at the creation time of the report
 * @property machine the machine that made the runs
 */
internal class Provenance(val build: String, val at: Instant, val machine: String)

/** Describes the method of the experiment as items of an HTML list. [made] contains the program and the machine. */
internal fun method(settings: Settings<Plan>, runs: List<Finished>, failed: List<Finished>, made: Provenance): String =
    method((if (settings.port == null) simulated(settings, runs) else real(settings.port)) + common(settings, failed, made))

internal fun method(parts: List<Pair<String, String>>): String =
    parts.joinToString("\n", "<h2>How it was made</h2>\n<ul>\n", "\n</ul>") { (what, how) -> "<li><strong>$what</strong>: $how</li>" }

private val AGENT = "Agent" to "<code>experiment/agent/robot.asl</code>, the one of Figure 7 of the paper, with these differences: " +
    "port, interval, limit and filter are beliefs; it believes that it has stopped; for light of at most 100 it sends " +
    "<code>ledLightOff</code>, where both published plans send <code>ledLightOn</code>, so a command in two is a byte longer; plans for " +
    "failures, and one that stops a robot whose run is given up, are added. (a): " +
    "<code>argo_sensing=in_cycle</code>, <code>protocol(1)</code>, commands unpaced. " +
    "(b): no option but the baud rate and the time an answer may take. (c): <code>protocol(2)</code>, and keep filters, so that requests " +
    "name the functors that the agent wants. (d): as (c), and each filter has a critical rule: a front distance of at most the limit, " +
    "with the reflex <code>stop</code>."

private fun simulated(settings: Settings<Plan>, runs: List<Finished>): List<Pair<String, String>> = listOf(
    "Robot" to "simulated. It starts ${Course.START_CM.toInt()} cm from the wall, drives at ${Course.SPEED_CM_S.toInt()} cm/s and " +
        "starts and stops at once; at 0 cm it has collided.",
    "Sensors" to "distance, light and temperature on four sides. All ${Sensors.PER_SET} readings change in each frame; a distance " +
        "reading is the next whole centimetre or up to ${Sensors.DISTANCE_NOISE} cm more.",
    "Line" to "9600 baud, each byte takes its ten bit times in each direction." +
        if (runs.isEmpty()) "" else " A request and its answer of twelve percepts take ${ofConditions(runs, ::exchangeMs)}.",
    "Board" to "(a) and (b): version 1 of Javino, one message at a time; of several that arrive while it answers it handles the last " +
        "one. (c): version 2 as the library in <code>javino-arduino</code> speaks it. (d): it also " +
        "watches the critical rule, reads its sensors every 5 ms for that, and stops the robot itself.",
    AGENT,
    "Computer" to "the reasoning of each agent, not its sensing thread, is slowed ${settings.slowdown} times: " +
        "${escaped(settings.computer)}. The comparison is of whole-number division only, with a single-board computer of 2016; " +
        "it is an assumption, and <code>--slowdown</code> sets another one. The published figure for the Raspberry Pi 3 Model B+ " +
        "(687.45 events a second at 1.4 GHz, " +
        "https://leoncode.co.uk/articles/raspberry-pi-benchmarks) is taken times 1.2/1.4 for the Model B of 2016, which has the same core.",
    "Time" to "real. ${lateness(runs)}",
)

private fun real(port: String): List<Pair<String, String>> = listOf(
    "Robot" to "a real one, on the port <code>${escaped(port)}</code>, which a person put ${Course.START_CM.toInt()} cm from the wall " +
        "before each run. Its speed, its board and its sensors are its own; " +
        "entries of collisions and the physical time to stop suppose ${Course.SPEED_CM_S.toInt()} cm/s.",
    "Measured" to "by its own front sensor, the only source of its position. Both times end when <code>stop</code> has left. The agent " +
        "perceives the wall with the first believed reading at or below the limit. The time of crossing the limit is estimated from that " +
        "reading and the one before, for a constant speed, and leaves out the time that readings take on their way. " +
        "${RealLaboratory.WALL_CM.toInt()} cm or less is the wall. Stopping distances are its last reading, a second later.",
    AGENT,
    "Computer" to "this one; reasoning is not slowed.",
)

private fun common(settings: Settings<Plan>, failed: List<Finished>, made: Provenance): List<Pair<String, String>> = listOf(
    "Order" to "random, all conditions mixed, seed ${settings.seed}: the same seed gives the same order. ${escaped(made.machine)}",
    "Program" to "ARGO ${escaped(made.build)}. The report was written at ${made.at.truncatedTo(ChronoUnit.SECONDS)}.",
    "Records" to "<code>runs.csv</code>, a line for each run, and <code>runs/*.jsonl</code>, one file a run: " +
        "${if (settings.port == null) "each frame, each command and " else ""}each change of the believed front distance with its time." +
        if (failed.isEmpty()) "" else " Failed and left out (${failed.size} in all): " +
            escaped(failed.joinToString("; ") { "${it.trial.id}: ${it.result.reason}" }),
)

/** Warns of the [runs] in which the machine was too late, by name. Without such runs, the text is empty. */
internal fun busyMachine(runs: List<Finished>): String {
    val late = runs.filter { it.isLate }.sortedBy { it.trial.id }.ifEmpty { return "" }
    return "<p><strong>The machine was busy.</strong> In ${late.size} of ${runs.size} runs it was later than their condition allows " +
        "(${limits(late)}), by ${whole(late.maxOf { it.result.lateMs })} ms at most, although each of them was made " +
        "${MAX_TRIES} times. Their times can be wrong by as much, and on an idle machine they may end differently. " +
        "They are hollow in the figures, the tables of times count them as late, " +
        (if (runs.any { it.trial.isScaled }) "the table of other lines has an asterisk behind them, " else "") +
        "and in <code>runs.csv</code> their <code>late_ms</code> exceeds their <code>late_limit_ms</code>.</p>\n" +
        "<details><summary>Runs of the busy machine</summary>\n<p>" +
        late.joinToString { "${it.trial.id} (${whole(it.result.lateMs)} ms)" } + "</p></details>\n"
}

internal fun lateness(runs: List<Finished>): String {
    val late = runs.map { it.result.lateMs }.ifEmpty { return "" }
    return "A thread wakes every 5 ms during each run. Its largest delay was ${one(late.max())} ms, the median of the largest delays of " +
        "${late.size} runs ${one(median(late))} ms. A run with a delay above a third of an exchange in its condition (${limits(runs)}) " +
        "was repeated, until it was made ${MAX_TRIES} times; ${runs.count { it.isLate }} of the counted runs still have one."
}

private fun exchangeMs(condition: Condition) =
    "${exchangeNanos(Trial(condition, View.NONE, limit = 0, interval = 0, replication = 1)) / 1_000_000} ms"

private fun limits(runs: List<Finished>) = ofConditions(runs) { "${whole(maxLateMs(it))} ms" }

private fun ofConditions(runs: List<Finished>, words: (Condition) -> String) =
    runs.map { it.trial.condition }.distinct().sorted().joinToString { "(${it.letter}) ${words(it)}" }
