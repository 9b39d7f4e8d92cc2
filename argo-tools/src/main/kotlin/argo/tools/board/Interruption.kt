package argo.tools.board

import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/**
 * Lets a command finish properly after Ctrl-C. Interrupts the thread that made this object, and delays the end of the program until
 * [close], for at most [LIMIT_S] seconds.
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
     * Returns true if the program is ending, or begins to end within [LATE_MS]: Ctrl-C goes to all programs of a terminal, and may end a
     * command's child programs before this one. Call it on the thread that made this object. If true, it clears that thread's interruption.
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
            // the program already ends
        }
    }

    private companion object {
        const val LIMIT_S = 5L
        const val LATE_MS = 500L
    }
}
