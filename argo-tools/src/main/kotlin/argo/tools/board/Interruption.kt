package argo.tools.board

import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/**
 * Lets a command finish its work after Ctrl-C. Interrupts the thread that made this object. Delays the end of the program until [close], by
 * up to [LIMIT_S] seconds.
 */
internal class Interruption : AutoCloseable {
    private val worker = Thread.currentThread()
    private val done = CountDownLatch(1)
    private val ending = CountDownLatch(1)
    private val hook = Thread {
        ending.countDown()
        worker.interrupt()
        done.await(LIMIT_S, TimeUnit.SECONDS)
    }

    init {
        Runtime.getRuntime().addShutdownHook(hook)
    }

    /**
     * Returns true if the program is ending, or starts to end within [LATE_MS]. Ctrl-C may end child programs before this program. Call
     * this function on the thread that made this object. A result of true clears the thread's interruption.
     */
    fun isEnding(): Boolean = try {
        ending.await(LATE_MS, TimeUnit.MILLISECONDS).also { if (it) Thread.interrupted() }
    } catch (_: InterruptedException) {
        true
    }

    override fun close() {
        done.countDown()
        try {
            Runtime.getRuntime().removeShutdownHook(hook)
        } catch (_: IllegalStateException) {
            // the program is already ending
        }
    }

    private companion object {
        const val LIMIT_S = 5L
        const val LATE_MS = 500L
    }
}
