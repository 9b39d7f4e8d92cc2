package argo.view

import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicBoolean
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The browsers that watch one view. Each has a thread of its own, which a browser that does not read can hold up and nothing else.
 * Safe for use by several threads.
 *
 * @param most how many there may be at once
 * @param nanos a clock in ns that never goes back
 */
internal class Browsers(private val most: Int, private val nanos: () -> Long) {
    private val watching = ConcurrentHashMap.newKeySet<Browser>()
    private val firstCame = CountDownLatch(1)
    private val newCame = AtomicBoolean()

    /** Whether there is one. */
    fun areWatching(): Boolean = watching.isNotEmpty()

    /** Whether one has come since this was asked last. */
    fun hasNewcomer(): Boolean = newCame.getAndSet(false)

    /** Waits until the first one watches, at most [limitMs] ms, and returns whether one does or has. */
    fun awaitFirst(limitMs: Long): Boolean = firstCame.await(limitMs, TimeUnit.MILLISECONDS)

    /** Serves one on the caller's thread until [serve] returns; false if there are too many already. */
    fun admit(serve: (Browser) -> Unit): Boolean {
        val browser = Browser(Thread.currentThread())
        watching += browser
        try {
            if (watching.size > most) return false
            newCame.set(true)
            firstCame.countDown()
            serve(browser)
            return true
        } finally {
            watching -= browser
            browser.isGone()
        }
    }

    /** Gives up those that have not taken what was written to them for [limitNanos] ns. */
    fun giveUpStalled(limitNanos: Long) = watching.forEach { it.giveUpIfStalled(limitNanos) }

    /** A browser that watches, and the thread that serves it. */
    inner class Browser(private val thread: Thread) {
        private val lock = ReentrantLock()
        private var isServed = true
        private var writingSince: Long? = null

        /** Does [write], which takes as long as the browser wants. */
        fun write(write: () -> Unit) {
            lock.withLock { writingSince = nanos() }
            write()
            lock.withLock { writingSince = null }
        }

        /** Its thread does something else from now on. */
        internal fun isGone() {
            lock.withLock { isServed = false }
            Thread.interrupted()
        }

        /** Ends a write that has begun [limitNanos] ns ago, and with it the connection. */
        internal fun giveUpIfStalled(limitNanos: Long) = lock.withLock {
            val since = writingSince
            if (isServed && since != null && nanos() - since > limitNanos) thread.interrupt()
        }
    }
}
