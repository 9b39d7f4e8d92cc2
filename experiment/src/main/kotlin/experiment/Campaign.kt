package experiment

import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.atomic.AtomicInteger

/**
 * Makes the missing runs of an experiment, [jobs] at a time in their order, and keeps their records.
 *
 * A run is repeated if this machine was late for its own simulation, see [punctual]. The last try counts, and its result records the delay.
 */
internal class Campaign(
    private val archive: Archive,
    private val settings: Settings,
    private val laboratory: Laboratory,
    private val jobs: Int,
    private val given: GivenUp,
    private val report: (Status) -> Unit,
) {
    /**
     * The progress: [done] of [all] runs are over, [collisions] of them at the wall. The other runs will take about [left] ms; 0: all have
     * begun. Runs were repeated [repeated] times because this machine was late; the estimate expects further repetitions.
     */
    internal data class Status(val done: Int, val all: Int, val collisions: Int, val left: Long, val repeated: Int = 0) {
        /** The facts for a line of progress. Minutes are whole, since [left] is no more exact. */
        val words: List<String> get() =
            listOfNotNull("run $done of $all", "$collisions at the wall", "$repeated repeated: machine late".takeIf { repeated > 0 }, rest)

        private val rest: String?
            get() = when {
                done == all -> null
                left == 0L -> if (all - done == 1) "the last run" else "the last ${all - done} runs"
                left + LONGEST_MS < MINUTE_MS -> "less than a minute left"
                else -> "about ${(left + LONGEST_MS + MINUTE_MS / 2) / MINUTE_MS} min left"
            }
    }

    private val repeated = AtomicInteger()

    /** The number of runs that were repeated because the machine was late. */
    val repetitions: Int get() = repeated.get()

    /**
     * Makes the missing runs of [trials]. Returns all finished runs. Ends early if the experiment is given up.
     *
     * @throws java.io.IOException if a record cannot be written; the experiment is then given up
     */
    fun run(trials: List<Trial>): List<Finished> {
        val wanted = trials.toSet()
        val over = ConcurrentLinkedQueue(archive.finished().filter { it.trial in wanted && it.result.outcome != Outcome.FAILED })
        val missing = ConcurrentLinkedQueue(trials - over.map { it.trial }.toSet())
        inParallel(jobs, given) { makeAll(missing, over, trials.size) }
        return over.toList()
    }

    private fun makeAll(missing: ConcurrentLinkedQueue<Trial>, over: ConcurrentLinkedQueue<Finished>, all: Int) {
        while (!given.isUp) {
            val collisions = over.count { it.result.outcome == Outcome.COLLIDED }
            val left = missing.sumOf(::expectedMs) / jobs
            report(Status(over.size, all, collisions, left + left * repetitions / maxOf(1, over.size), repetitions))
            val trial = missing.poll() ?: return
            over += punctual(Finished::isLate, repeated::incrementAndGet) { recorded(trial) } ?: return
        }
    }

    private fun recorded(trial: Trial): Finished? = RecordWriter(archive.file(trial)).use { record ->
        record.write(Entry.Begin(trial, settings))
        laboratory.run(trial, record, given)?.also(record::write).also { record.requireWhole() }?.let { Finished(trial, it) }
    }

    companion object {
        private const val MINUTE_MS = 60_000L

        /** The longest time of a run, in ms, from the start to the wall, unless the run fails. */
        private const val LONGEST_MS = 21_000L

        /** Estimates the time of [trial], in ms: until a little beyond the limit, or until the wall if a collision is expected. */
        fun expectedMs(trial: Trial): Long {
            val hits = trial.condition == Condition.PUBLISHED && trial.view == View.NONE
            return 1_000L + (200 - if (hits) 0 else trial.limit) * 100L
        }
    }
}
