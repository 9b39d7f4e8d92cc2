package argo.observing

import kotlin.concurrent.thread

/**
 * Runs [say] on its own thread if the program ends, for example by Ctrl-C, before this object is closed. The program waits for [say], but
 * at most [mostMs] ms, since a disk or a browser may hang. If [say] takes longer, [tell] gets the message [unsaid]. By default [tell]
 * writes to standard error, since Java may have closed the log. Safe for use by several threads.
 */
class Farewell(
    private val mostMs: Long,
    private val unsaid: String,
    private val tell: (String) -> Unit = System.err::println,
    private val say: () -> Unit,
) : AutoCloseable {
    private val atExit = Thread(::bid, "argo-farewell")

    init {
        Runtime.getRuntime().addShutdownHook(atExit)
    }

    internal fun bid() {
        val saying = thread(isDaemon = true, block = say)
        saying.join(mostMs)
        if (saying.isAlive) tell(unsaid)
    }

    /** Cancels [say]. Further calls have no effect. May be called while the program ends. */
    override fun close() {
        try {
            Runtime.getRuntime().removeShutdownHook(atExit)
        } catch (_: IllegalStateException) {
            // the program is ending
        }
    }
}
