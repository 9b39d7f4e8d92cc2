package experiment

import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.atomic.AtomicInteger

/** Makes the runs [T] of an experiment into finished runs [R]. Several threads may call these functions. */
internal interface Runs<T, R : Any> {
    /** Returns the finished runs, which are not made again. */
    fun finished(): Map<T, R>

    /**
     * Makes [run], and keeps its record. Returns null if [given] tells that the experiment is aborted.
     *
     * @throws java.io.IOException if the record cannot be written
     */
    fun make(run: T, given: GivenUp): R?

    /** Returns true if this machine was too late for its own simulation in the finished run [made]. */
    fun isLate(made: R): Boolean

    /** Estimates the time of [run], in ms. */
    fun expectedMs(run: T): Long

    /** Returns facts about the finished runs [over], for the line of progress. */
    fun facts(over: Collection<R>): List<String> = emptyList()
}

/**
 * Makes the missing [runs] of an experiment in their order, [jobs] of them at a time.
 *
 * A run is repeated if this machine was too late for its own simulation, see [punctual]. The last try counts, and its record has the delay.
 */
internal class Campaign<T, R : Any>(
    private val runs: Runs<T, R>,
    private val jobs: Int,
    private val given: GivenUp,
    private val report: (Status) -> Unit,
) {
    /**
     * The progress: [done] of [all] runs are over, and [facts] are about these. The other runs will take about [left] ms; 0: all have
     * begun. Runs were repeated [repeated] times because this machine was late; [left] allows for further repetitions.
     */
    internal data class Status(
        val done: Int, val all: Int, val left: Long, val repeated: Int = 0, val facts: List<String> = emptyList(),
    ) {
        /** The facts for a line of progress. The time left is in whole minutes, since [left] is only an estimate. */
        val words: List<String> get() =
            listOf("run $done of $all") + facts + listOfNotNull("$repeated repeated: machine late".takeIf { repeated > 0 }, rest)

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
     * Makes those of [all] runs that are missing, and returns all finished runs. Ends early if the experiment is aborted.
     *
     * @throws java.io.IOException if a record cannot be written; the experiment is then aborted
     */
    fun run(all: List<T>): List<R> {
        val finished = runs.finished()
        val over = ConcurrentLinkedQueue(all.mapNotNull(finished::get))
        val missing = ConcurrentLinkedQueue(all - finished.keys)
        inParallel(jobs, given) { makeAll(missing, over, all.size) }
        return over.toList()
    }

    private fun makeAll(missing: ConcurrentLinkedQueue<T>, over: ConcurrentLinkedQueue<R>, all: Int) {
        while (!given.isUp) {
            val left = missing.sumOf(runs::expectedMs) / jobs
            report(Status(over.size, all, left + left * repetitions / maxOf(1, over.size), repetitions, runs.facts(over)))
            val run = missing.poll() ?: return
            over += punctual(runs::isLate, repeated::incrementAndGet) { runs.make(run, given) } ?: return
        }
    }

    private companion object {
        const val MINUTE_MS = 60_000L

        /** The longest time of a run that does not fail, in any experiment, in ms. */
        const val LONGEST_MS = 21_000L
    }
}
