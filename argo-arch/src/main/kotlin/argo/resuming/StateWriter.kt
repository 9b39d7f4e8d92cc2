package argo.resuming

import argo.observing.Farewell
import argo.platform.Platform
import argo.platform.SequentialExecutor
import java.io.IOException
import java.util.concurrent.CountDownLatch
import java.util.concurrent.atomic.AtomicReference
import java.util.logging.Logger

/**
 * Writes the states of the agent called [name] to [file], on a thread of its own. While a slow disk writes one state, only the newest of
 * the later states waits. Any thread may call; none waits for the disk.
 *
 * @param end asks for the last state if Java ends before the agent: [end][StateWriter.end] is called soon
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
    private var hasFailed = false // of the writing thread
    private val farewell = Farewell(MAX_FAREWELL_MS, "argo_resume: the program has ended before agent $name's last state was in $file") {
        end()
        isEnded.await()
    }

    fun write(state: State) {
        next.set(state)
        thread.execute(::writeNext)
    }

    /** Gives the file back when the last state is written. */
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
