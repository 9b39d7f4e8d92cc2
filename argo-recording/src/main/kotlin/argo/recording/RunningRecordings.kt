package argo.recording

import java.nio.file.Path
import java.util.concurrent.CopyOnWriteArrayList

/** What records an agent of this program now. */
interface RunningRecording {
    /** The name of the agent. */
    val agent: String

    /** Why it has ended before its agent, a sentence for a person; null: it has not. */
    val trouble: String?

    /**
     * Calls [use] with a file that holds what has been recorded so far. The file grows meanwhile, or is deleted afterwards. Waits for the
     * disk, so the agent's thread is not to call it.
     *
     * @throws java.io.IOException if there is no such file, or it cannot be written
     */
    fun <T> read(use: (Path) -> T): T
}

/**
 * The recordings that agents of this program are making. They are known to the whole program on purpose, since what shows them knows no
 * recorder. Safe for use by several threads.
 */
object RunningRecordings {
    private val all = CopyOnWriteArrayList<RunningRecording>()

    /** That of the agent called [agent], the newest if there are several; null: it is not recorded. */
    fun of(agent: String): RunningRecording? = all.lastOrNull { it.agent == agent }

    internal fun add(recording: RunningRecording) {
        all += recording
    }

    internal fun remove(recording: RunningRecording) {
        all -= recording
    }
}
