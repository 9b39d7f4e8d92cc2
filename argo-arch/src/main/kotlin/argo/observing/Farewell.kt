package argo.observing

import kotlin.concurrent.thread

/**
 * If something outside ends the program before this is closed, as Ctrl-C does, runs [say] on its own thread. The program waits for [say],
 * but no longer than [mostMs]: a hanging disk or browser does not keep it from ending. Safe for use by several threads.
 */
class Farewell(private val mostMs: Long, private val say: () -> Unit) : AutoCloseable {
    private val atExit = Thread({ thread(isDaemon = true, block = say).join(mostMs) }, "argo-farewell")

    init {
        Runtime.getRuntime().addShutdownHook(atExit)
    }

    /** Cancels [say]. Idempotent; may be called while the program ends. */
    override fun close() {
        try {
            Runtime.getRuntime().removeShutdownHook(atExit)
        } catch (_: IllegalStateException) {
            // the program is ending
        }
    }
}
