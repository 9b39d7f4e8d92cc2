package argo.tools.board

import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/**
 * Lets Ctrl-C end a command in good order: interrupts the thread that made this, and holds up the end of the program until [close], for
 * [LIMIT_S] seconds at most.
 */
internal class Interruption : AutoCloseable {
    private val worker = Thread.currentThread()
    private val done = CountDownLatch(1)
    private val hook = Thread {
        worker.interrupt()
        done.await(LIMIT_S, TimeUnit.SECONDS)
    }

    init {
        Runtime.getRuntime().addShutdownHook(hook)
    }

    override fun close() {
        done.countDown()
        try {
            Runtime.getRuntime().removeShutdownHook(hook)
        } catch (_: IllegalStateException) {
            // the program is ending already
        }
    }

    private companion object {
        const val LIMIT_S = 5L
    }
}
