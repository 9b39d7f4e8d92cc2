package argo.recording.replay

import argo.recording.agent.ProgramNames
import argo.recording.isProgram
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path
import kotlin.io.path.createTempDirectory

/**
 * Writes the programs in [recording] to files in a temporary directory. [close] or the end of Java removes the directory.
 *
 * @throws RecordingException if a program would be outside of the directory, or names a class that is no internal action or function
 */
internal class ProgramFiles(private val recording: Recording) : AutoCloseable {
    private val directory: Path = createTempDirectory("argo-replay")

    private val removal = Thread { directory.toFile().deleteRecursively() }

    init {
        Runtime.getRuntime().addShutdownHook(removal)
        runCatching { extract(directory) }.onFailure { close() }.getOrThrow()
    }

    /** Returns the program of [agent]. Throws [RecordingException] if the recording lacks the program. */
    fun of(agent: String): Path {
        val source = recording.agents.getValue(agent).source
        if (source !in recording.program || !isProgram(source)) {
            throw RecordingException("the recording does not hold the program of agent $agent")
        }
        return directory.resolve(source)
    }

    private fun extract(directory: Path) = recording.program.filterKeys(::isProgram).forEach { (name, text) ->
        val file = try {
            directory.resolve(name).normalize()
        } catch (_: InvalidPathException) {
            null
        }
        if (file == null || !file.startsWith(directory)) {
            throw RecordingException("the recording has a file outside of its programs: $name")
        }
        ProgramNames(text.decodeToString()).classes.forEach(GuardedAgent::requireCode)
        Files.createDirectories(file.parent)
        Files.write(file, text)
    }

    override fun close() {
        removal.run()
        try {
            Runtime.getRuntime().removeShutdownHook(removal)
        } catch (_: IllegalStateException) {
            // Java is ending
        }
    }
}
