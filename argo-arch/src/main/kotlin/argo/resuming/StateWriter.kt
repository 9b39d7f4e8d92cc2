package argo.resuming

import argo.observing.Farewell
import argo.platform.Platform
import argo.platform.SequentialExecutor
import java.io.IOException
import java.util.concurrent.CountDownLatch
import java.util.concurrent.atomic.AtomicReference
import java.util.logging.Logger

/**
 * Writes the states of the agent called [name] to [file], on a separate thread. While a slow disk writes one state, only the newest of the
 * later states is kept for the next write. Any thread may call the functions. No caller waits for the disk.
 *
 * @param end called if Java ends before the agent; makes the agent write its last state and call [end][StateWriter.end]
 */
internal class StateWriter(
    private val file: StateFile,
    name: String,
    platform: Platform,
    private val log: Logger,
    end: () -> Unit,
) {
    private val thread = SequentialExecutor(platform, "argo-$name-state")
    private val next = AtomicReference<State?>()
    private val isEnded = CountDownLatch(1)
    private var hasFailed = false // only for the writing thread
    private val farewell = Farewell(MAX_FAREWELL_MS, "argo_resume: the program has ended before agent $name's last state was in $file") {
        end()
        isEnded.await()
    }

    fun write(state: State) {
        next.set(state)
        thread.execute(::writeNext)
    }

    /** Releases the file after the last state has been written. */
    fun end() = thread.execute {
        file.close()
        farewell.close()
        isEnded.countDown()
    }

    private fun writeNext() {
        val state = next.getAndSet(null) ?: return
        try {
            file.exchange(state.text())
            if (hasFailed) log.info("$file is written again")
            hasFailed = false
        } catch (trouble: IOException) {
            if (!hasFailed) log.severe("argo_resume: $file cannot be written, and stays as it is: $trouble; each later state is tried")
            hasFailed = true
        }
    }

    private companion object {
        const val MAX_FAREWELL_MS = 2000L
    }
}
