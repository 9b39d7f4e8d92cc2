package argo.view

import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.Executor
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.ThreadPoolExecutor
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The threads that answer the requests to a view, one for each at a time. A request for which there is none at the moment waits for its turn.
 *
 * A program that begins requests and does not end them holds threads up; [giveUpUnfinished] takes them back. Safe for use by several threads.
 *
 * @param agent whose view it is, for the threads' names
 * @param nanos a clock in ns that never goes back
 */
internal class RequestThreads(agent: String, private val nanos: () -> Long) : Executor {
    private val numbers = AtomicInteger()
    private val unfinished = ConcurrentHashMap<Thread, Request>()
    private val pool = ThreadPoolExecutor(MOST_THREADS, MOST_THREADS, IDLE_S, TimeUnit.SECONDS, LinkedBlockingQueue(MOST_WAITING)) { work ->
        Thread(work, "argo-$agent-view-${numbers.incrementAndGet()}").apply { isDaemon = true }
    }.apply { allowCoreThreadTimeOut(true) }

    override fun execute(request: Runnable) = pool.execute {
        val begun = Request(Thread.currentThread(), nanos())
        unfinished[begun.thread] = begun
        try {
            request.run()
        } finally {
            unfinished -= begun.thread
            begun.end()
        }
    }

    /** The request that the calling thread serves has come whole: what takes long from now on is not its sender's doing. */
    fun received() {
        unfinished.remove(Thread.currentThread())?.end()
    }

    /** Ends requests that have not come whole for [limitNanos] ns, or a tenth of it while others wait for a thread, and with them their connections. */
    fun giveUpUnfinished(limitNanos: Long) {
        val limit = if (pool.queue.isEmpty()) limitNanos else limitNanos / 10
        unfinished.values.forEach { if (nanos() - it.sinceNanos > limit) it.giveUp() }
    }

    /** Ends all requests and threads; returns when they have ended, or after a second. */
    fun stop() {
        pool.shutdownNow()
        pool.awaitTermination(1, TimeUnit.SECONDS)
    }

    private class Request(val thread: Thread, val sinceNanos: Long) {
        private val lock = ReentrantLock()
        private var isServed = true

        /** Its thread does something else from now on. */
        fun end() {
            lock.withLock { isServed = false }
            Thread.interrupted()
        }

        /** Ends what its thread waits for. */
        fun giveUp() = lock.withLock { if (isServed) thread.interrupt() }
    }

    private companion object {
        /** Twice as many as there are pages at most, each of which holds one. */
        const val MOST_THREADS = 24
        const val MOST_WAITING = 200
        const val IDLE_S = 5L
    }
}
