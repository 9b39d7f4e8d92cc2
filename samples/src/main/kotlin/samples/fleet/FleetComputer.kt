package samples.fleet

import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/**
 * A computer of a fleet, which is a process here: `argo-fleet.jar` in the directory of the project.
 *
 * @property name the computer's name in the `.mas2j`, behind `at`
 * @param printed called with each line that the process prints, on a thread that reads them
 */
internal class FleetComputer private constructor(
    val name: String, private val process: Process, printed: (String) -> Unit,
) : AutoCloseable {
    private val reader = thread(isDaemon = true, name = "computer $name") {
        try {
            process.inputStream.bufferedReader().forEachLine(printed)
        } catch (_: IOException) {
            // a destroyed process loses its unread output
        }
    }

    val isAlive: Boolean get() = process.isAlive

    /** Ends its process at once, as a power failure does. */
    fun kill() {
        process.destroyForcibly().waitFor()
        reader.join()
    }

    /** Asks its process to end; kills it if it does not end in time. */
    override fun close() {
        process.destroy()
        if (!process.waitFor(PATIENCE_S, TimeUnit.SECONDS)) process.destroyForcibly().waitFor()
        reader.join()
    }

    companion object {
        private const val PATIENCE_S = 5L

        /** Starts the computer [name] of [project], a `.mas2j` file, by [java] on [classPath]. */
        fun start(project: Path, name: String, java: String, classPath: String, printed: (String) -> Unit): FleetComputer {
            val program = listOf("-XX:TieredStopAtLevel=1", "-cp", classPath, "argo.fleet.MainKt", "${project.fileName}", "--at", name)
            val process = ProcessBuilder(listOf(java) + program)
                .directory(project.parent.toFile()).redirectErrorStream(true).start()
            return FleetComputer(name, process, printed)
        }
    }
}
