package experiment.report

import experiment.Campaign
import experiment.Condition
import experiment.Finished
import experiment.maxLateMs

/** Writes the warning that the machine was too late in some of [runs], with their names; an empty text if it was not. */
internal fun busyMachine(runs: List<Finished>): String {
    val late = runs.filter { it.isLate }.sortedBy { it.trial.id }.ifEmpty { return "" }
    return "<p><strong>The machine was busy.</strong> In ${late.size} of ${runs.size} runs it was later than their condition allows " +
        "(${limits(late)}), by ${whole(late.maxOf { it.result.lateMs })} ms at most, although each of them was made " +
        "${Campaign.MAX_TRIES} times. Their times can be wrong by as much, and on an idle machine they may end differently. " +
        "They are hollow in the figures, have an asterisk in the table of other lines, and in <code>runs.csv</code> their " +
        "<code>late_ms</code> exceeds their <code>late_limit_ms</code>.</p>\n<details><summary>Runs of the busy machine</summary>\n<p>" +
        late.joinToString { "${it.trial.id} (${whole(it.result.lateMs)} ms)" } + "</p></details>\n"
}

/** Describes the lateness of the machine in [runs], and the runs that were repeated for it. */
internal fun lateness(runs: List<Finished>): String {
    val late = runs.map { it.result.lateMs }.ifEmpty { return "" }
    return "A thread wakes every 5 ms during each run. Its largest delay was ${one(late.max())} ms, the median of the largest delays of " +
        "${late.size} runs ${one(median(late))} ms. A run with a delay above a third of an exchange in its condition (${limits(runs)}) " +
        "was repeated, until it was made ${Campaign.MAX_TRIES} times; ${runs.count { it.isLate }} of the counted runs still have one."
}

private fun limits(runs: List<Finished>) = runs.map { it.trial.condition }.distinct().sorted().joinToString(transform = ::limit)

private fun limit(condition: Condition) = "(${condition.letter}) ${whole(maxLateMs(condition))} ms"
