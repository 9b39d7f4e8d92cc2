package experiment

import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import java.util.concurrent.Future

/**
 * Does [work] on [jobs] threads at once, and returns when all of them have ended. If [work] fails on one thread, aborts the experiment, so
 * that the other threads end soon, and throws the failure.
 */
internal fun inParallel(jobs: Int, given: GivenUp, work: () -> Unit) {
    val pool = Executors.newFixedThreadPool(jobs)
    val workers = List(jobs) { pool.submit { work(given, work) } }
    pool.shutdown()
    workers.mapNotNull(::failure).firstOrNull()?.let { throw it } // thrown only when all workers have ended
}

private fun failure(worker: Future<*>): Throwable? = try {
    worker.get()
    null
} catch (failed: ExecutionException) {
    failed.cause
}

private fun work(given: GivenUp, work: () -> Unit) {
    var isDone = false
    try {
        work()
        isDone = true
    } finally {
        if (!isDone) given.giveUp() // or the failure would be reported only when all runs are made
    }
}
