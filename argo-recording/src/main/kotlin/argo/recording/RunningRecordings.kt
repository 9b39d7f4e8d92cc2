package argo.recording

import java.nio.file.Path
import java.util.concurrent.CopyOnWriteArrayList

/** A recording in progress, of one agent of this program. */
interface RunningRecording {
    /** The agent's name. */
    val agent: String

    /** The reason why the recording has ended before its agent, in words; null if it has not ended. */
    val trouble: String?

    /**
     * Calls [use] with a file that contains the recording so far. During the call the file may grow. After the call it may be deleted. The
     * function waits for the disk, so the agent's thread must not call it.
     *
     * @throws java.io.IOException if there is no file with the recording, or the file cannot be written
     */
    fun <T> read(use: (Path) -> T): T
}

/**
 * The recordings in progress of this program's agents. The live view finds them here, so it does not depend on the recorder. Safe for use
 * by several threads.
 */
object RunningRecordings {
    private val all = CopyOnWriteArrayList<RunningRecording>()

    /** Returns the recording of the agent called [agent]; the newest if there are several, null if the agent is not recorded. */
    fun of(agent: String): RunningRecording? = all.lastOrNull { it.agent == agent }

    internal fun add(recording: RunningRecording) {
        all += recording
    }

    internal fun remove(recording: RunningRecording) {
        all -= recording
    }
}
