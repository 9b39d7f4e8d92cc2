package experiment

import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import java.util.concurrent.Future

/**
 * Makes [jobs] threads do [work], and returns when all have ended. If [work] fails in one of them, the experiment is given up, so that the
 * others end soon, and the failure is thrown.
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
        if (!isDone) given.giveUp() // otherwise the failure is reported an hour later
    }
}
