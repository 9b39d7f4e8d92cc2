package experiment

import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import java.util.concurrent.Future

/**
 * Does [work] on [jobs] threads, and returns when all have ended. If [work] fails on one thread, aborts the experiment so that the others
 * end soon. Then throws the failure.
 */
internal fun inParallel(jobs: Int, given: GivenUp, work: () -> Unit) {
    val pool = Executors.newFixedThreadPool(jobs)
    val workers = List(jobs) { pool.submit { work(given, work) } }
    pool.shutdown()
    workers.mapNotNull(::failure).firstOrNull()?.let { throw it } // thrown only after the end of all workers
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
        if (!isDone) given.giveUp() // reports the failure before all runs are made
    }
}
