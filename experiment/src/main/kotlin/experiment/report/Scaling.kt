package experiment.report

import experiment.Finished
import experiment.Outcome
import experiment.exchangeNanos
import experiment.isLate
import experiment.leavesTime

internal class Scaling(private val runs: List<Finished>) {
    val scale: TimeScale = TimeScale.of(runs.filter { it.result.outcome == Outcome.STOPPED }.map { it.result.sinceLimitMs / 1000 })
    private val bauds = runs.map { it.trial.baud }.distinct().sorted()

    fun introduction(): String {
        val trial = runs.first().trial
        return """<p>A limit of ${trial.limit} cm, an interval of ${trial.interval} ms, one run for each field (n = ${runs.size}):
${scale.word} from the limit to the stop, or another outcome.
Further sensors are sets of the same twelve; each set triggers as many plans as the first.</p>
<p>A version 1 message holds 255 bytes, about twenty percepts, and a board with more sends several. Each is a snapshot of its own to the
computer: an agent that sees the front in the first
does not in the next. The first is also taken for the whole answer, so commands and the next request arrive while the board still sends.
A board that holds one message then loses the one
before the last. If a request follows a command within that time, which an interval of ${trial.interval} ms makes likely, the board loses
the command: the robot never drives, or is not stopped.
Version 2 has no such bound: its answers come whole, and its commands are acknowledged.</p>
"""
    }

    /**
     * Returns the table of the outcomes with the name [number]. The table contains the baud rate from which each condition stops on all
     * lines.
     */
    fun table(number: String): String = table(
        "$number. ${word()} from the limit to the stop, for each number of sensors and each line.",
        listOf("condition", "filter", "sensors") + bauds.map { "$it baud" } + listOf("stops on all lines from", "exchange there, ms"),
        runs.groupBy { Triple(it.trial.condition, it.trial.view, it.trial.sensors) }
            .toSortedMap(compareBy({ it.first }, { it.second }, { it.third })).values.map(::row),
        words = 2,
    ) + "<p class=\"soft\">${explained()} An exchange is the time of a request and its whole answer " +
        "on the line.</p>\n"

    private fun row(cell: List<Finished>): List<String> {
        val trial = cell.first().trial
        val byBaud = cell.associateBy { it.trial.baud }
        val stopsFrom = bauds.takeLastWhile { baud -> byBaud[baud]?.let { it.result.outcome == Outcome.STOPPED } ?: true }
            .firstOrNull { it in byBaud }
        return listOf("(${trial.condition.letter})", words(trial.view), "${trial.sensors}") +
            bauds.map { baud -> byBaud[baud]?.let { fate(it, scale) } ?: "–" } +
            listOf(stopsFrom?.let { "$it baud" } ?: "none", stopsFrom?.let { "${exchangeNanos(trial.copy(baud = it)) / 1_000_000}" } ?: "–")
    }

    fun explained(): String = "${word()} from the limit to the stop. wall: it ran into the wall. too slow: it did too, and the line by " +
        "itself takes longer than the limit leaves, whatever the program does. idle: no command to drive took effect. failed: the agent " +
        "gave up, or the run ended otherwise. *: the machine was busy."

    private fun word() = scale.word.replaceFirstChar(Char::uppercase)
}

internal fun fate(run: Finished, scale: TimeScale): String = when (run.result.outcome) {
    Outcome.STOPPED -> scale.text(run.result.sinceLimitMs / 1000)
    Outcome.COLLIDED -> if (leavesTime(run.trial)) "wall" else "too slow"
    Outcome.IDLE -> "idle"
    Outcome.FAILED -> "failed"
} + if (run.isLate) "*" else ""
