package experiment.report

import experiment.Finished
import experiment.maxLateMs

/**
 * Writes [runs] as comma-separated values (RFC 4180). The first line has the column names, and each other line a run.
 *
 * @param seed the seed for the order of the runs
 * @param build the version and the commit of ARGO, in words
 */
internal fun csv(runs: List<Finished>, seed: Long, build: String): String {
    val heads = "run,condition,filter,limit_cm,interval_ms,replication,baud,sensors,outcome,since_limit_ms,since_perceiving_ms," +
        "distance_cm,commands,frames,late_ms,late_limit_ms,reason,seed,argo"
    val lines = runs.sortedBy { it.trial.id }.map { "${line(it)},$seed,${quoted(build)}" }
    return (listOf(heads) + lines).joinToString("") { "$it\r\n" }
}

private fun line(run: Finished): String = run.let { (trial, result) ->
    listOf(
        trial.id, trial.condition.letter, trial.view.word, trial.limit, trial.interval, trial.replication, trial.baud, trial.sensors,
        result.outcome.name.lowercase(), three(result.sinceLimitMs), result.sincePerceivingMs?.let(::three).orEmpty(),
        three(result.distance), result.commands, result.frames, three(result.lateMs), three(maxLateMs(trial.condition)),
        quoted(result.reason.orEmpty()),
    ).joinToString(",")
}

private fun quoted(text: String) = if (text.any { it in ",\"\r\n" }) "\"${text.replace("\"", "\"\"")}\"" else text
