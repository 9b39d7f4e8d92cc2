package argo.recording

import java.nio.file.Path
import java.util.concurrent.CopyOnWriteArrayList

/** A recording of an agent of this program that is being made. */
interface RunningRecording {
    /** The name of the agent. */
    val agent: String

    /** The reason why the recording has ended before its agent, a sentence for a person; null: it has not. */
    val trouble: String?

    /**
     * Calls [use] with a file that holds the recording so far. The file grows meanwhile, or is deleted afterwards. Waits for the disk, so
     * the agent's thread must not call it.
     *
     * @throws java.io.IOException if there is no such file, or it cannot be written
     */
    fun <T> read(use: (Path) -> T): T
}

/**
 * The recordings that agents of this program are making. The whole program knows them on purpose, since the live view, which shows them,
 * knows no recorder. Safe for use by several threads.
 */
object RunningRecordings {
    private val all = CopyOnWriteArrayList<RunningRecording>()

    /** Returns the recording of the agent called [agent], the newest if there are several; null: the agent is not recorded. */
    fun of(agent: String): RunningRecording? = all.lastOrNull { it.agent == agent }

    internal fun add(recording: RunningRecording) {
        all += recording
    }

    internal fun remove(recording: RunningRecording) {
        all -= recording
    }
}
