package experiment

import java.util.concurrent.Callable
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.Executors
import java.util.concurrent.atomic.AtomicInteger

/** Makes the runs [T] of an experiment, and turns them into finished runs [R]. Safe for use by several threads. */
internal interface Runs<T, R : Any> {
    fun finished(): Map<T, R>

    /**
     * Makes [run] and stores its record. Returns null if [given] has aborted the experiment.
     *
     * @throws java.io.IOException if the record cannot be written
     */
    fun make(run: T, given: GivenUp): R?

    /** Returns true if this machine was too slow for its own simulation in the finished run [made]. */
    fun isLate(made: R): Boolean

    fun expectedMs(run: T): Long

    fun facts(over: Collection<R>): List<String> = emptyList()
}

/**
 * Makes the missing [runs] of an experiment in order, with [jobs] at a time.
 *
 * A run is repeated if this machine was too slow for its own simulation; [punctual] decides. The last try counts. The record of a run
 * contains the delay.
 */
internal class Campaign<T, R : Any>(
    private val runs: Runs<T, R>,
    private val jobs: Int,
    private val given: GivenUp,
    private val report: (Status) -> Unit,
) {
    /**
     * The progress. [done] of [all] runs have ended, with these [facts]. The other runs will take about [left] ms. 0 means that all have
     * started. [repeated] counts the repetitions because of a slow machine. [left] includes expected repetitions.
     */
    internal data class Status(
        val done: Int, val all: Int, val left: Long, val repeated: Int = 0, val facts: List<String> = emptyList(),
    ) {
        /** The parts of the line of progress. The remaining time is in whole minutes, since [left] is an estimate. */
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

    val repetitions: Int get() = repeated.get()

    /**
     * Makes the missing ones of [all] runs, and returns all finished runs. Ends early if the experiment is aborted.
     *
     * @throws java.io.IOException if a record cannot be written. The experiment is then aborted
     */
    fun run(all: List<T>): List<R> {
        val finished = runs.finished()
        val over = ConcurrentLinkedQueue(all.mapNotNull(finished::get))
        val missing = ConcurrentLinkedQueue(all - finished.keys)
        val pool = Executors.newFixedThreadPool(jobs)
        val workers = pool.invokeAll(
            List(jobs) { Callable { runCatching { makeAll(missing, over, all.size) }.onFailure { given.giveUp() } } },
        )
        pool.shutdown()
        workers.forEach { it.get().getOrThrow() }
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

        /** The longest duration of a successful run in any experiment, in ms. */
        const val LONGEST_MS = 21_000L
    }
}
