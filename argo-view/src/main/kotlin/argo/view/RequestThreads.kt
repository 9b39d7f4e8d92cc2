package argo.view

import java.util.concurrent.Executor
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.ThreadPoolExecutor
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The threads that answer requests to a server of views. Each thread answers one request at a time. If a client does not finish its request
 * or read its response, it blocks its thread until [interruptStalled]. Safe for use by several threads.
 *
 * @param name the server's name, for the threads' names
 * @param nanos a clock in ns that never goes back
 */
internal class RequestThreads(name: String, private val nanos: () -> Long) : Executor {
    private val lock = ReentrantLock()
    private val waitingSince = HashMap<Thread, Long>()
    private val numbers = AtomicInteger()
    private val pool = ThreadPoolExecutor(MAX_THREADS, MAX_THREADS, IDLE_S, TimeUnit.SECONDS, LinkedBlockingQueue(MAX_QUEUED)) { work ->
        Thread(work, "argo-$name-view-${numbers.incrementAndGet()}").apply { isDaemon = true }
    }.apply { allowCoreThreadTimeOut(true) }

    /** Runs [request], which begins by reading from its client, see [stopWaiting]. */
    override fun execute(request: Runnable) = pool.execute { waiting { request.run() } }

    /** Does [io] while the calling thread waits for its client. */
    inline fun waiting(io: () -> Unit) {
        lock.withLock { waitingSince[Thread.currentThread()] = nanos() }
        try {
            io()
        } finally {
            stopWaiting()
        }
    }

    /** Ends the calling thread's wait for its client. */
    fun stopWaiting() = lock.withLock {
        if (waitingSince.remove(Thread.currentThread()) == null) Thread.interrupted() // the wait is over, so clears its interrupt
    }

    /**
     * Ends waits of more than [MAX_WAIT_NANOS], and closes their connections. If requests are queued, a tenth of this time is the limit.
     */
    fun interruptStalled() = lock.withLock {
        val limit = if (pool.queue.isEmpty()) MAX_WAIT_NANOS else MAX_WAIT_NANOS / 10
        waitingSince.entries.removeIf { (thread, since) -> (nanos() - since > limit).also { if (it) thread.interrupt() } }
    }

    /** Ends all requests and threads. Returns when they have ended, or after a second. */
    fun stop() {
        pool.shutdownNow()
        pool.awaitTermination(1, TimeUnit.SECONDS)
    }

    companion object {
        /** How long a client may take to send its request or to read its response. This is enough for a slow tunnel. */
        val MAX_WAIT_NANOS = TimeUnit.SECONDS.toNanos(10)

        /** Twice the largest number of pages. Each page occupies one thread. */
        private const val MAX_THREADS = 24
        private const val MAX_QUEUED = 200
        private const val IDLE_S = 5L
    }
}
