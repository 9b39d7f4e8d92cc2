package experiment

import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.nio.file.StandardOpenOption
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * The settings for all runs of an experiment. The settings must not change when the experiment is continued.
 *
 * @property seed the seed for the order of the runs and for random numbers in them
 * @property slowdown the factor by which the agents reason slower than this computer
 * @property computer the origin of [slowdown], in words
 * @property port the port of a real robot, or null for simulated robots
 */
@Serializable
internal data class Settings<P>(val plan: P, val seed: Long, val slowdown: Double, val computer: String, val port: String? = null)

/** An experiment cannot be continued; [message] gives the reason and the remedy. */
internal class ContinuationException(message: String) : Exception(message)

/**
 * The directory of an experiment, with its settings in `settings.json` and its records in `runs/`. From [open] to [close], no other
 * experiment can use it.
 *
 * @param plans the serializer of the plan in `settings.json`
 * @param read reads a finished run from its record, or returns null if the record is incomplete and the run must be repeated
 */
internal class Archive<P, R : Any>(val directory: Path, plans: KSerializer<P>, private val read: (Path) -> R?) : AutoCloseable {
    private val form = Settings.serializer(plans)
    private val settingsFile = directory.resolve("settings.json")
    private val runs = directory.resolve("runs")
    private var claim: FileChannel? = null

    /**
     * Returns the settings of the experiment in this directory, or null if there is none.
     *
     * @throws ContinuationException if they cannot be read
     */
    fun settings(): Settings<P>? {
        if (!settingsFile.exists()) return null
        return try {
            JSON.decodeFromString(form, settingsFile.readText())
        } catch (damaged: SerializationException) {
            throw ContinuationException(
                "$settingsFile cannot be read (${damaged.message?.lineSequence()?.first()}); " +
                    "choose another directory with --out, or delete it",
            )
        }
    }

    /**
     * Starts an experiment with the settings [asked], or continues the experiment in this directory.
     *
     * @throws ContinuationException if the experiment has other settings, or if another program runs it
     * @throws IOException if the directory cannot be written to
     */
    fun open(asked: Settings<P>) {
        Files.createDirectories(runs)
        if (claim == null) claim = claim(directory)
        val present = settings()
        if (present != null && present != asked) throw ContinuationException(
            "$directory holds an experiment with other settings: ${differences(present, asked)}. Continue it with its own, or choose " +
                "another directory with --out",
        )
        if (present == null) begin(asked)
    }

    /** Writes all settings or none, even if the program is killed. */
    private fun begin(asked: Settings<P>) {
        val whole = settingsFile.resolveSibling("settings.json.new")
        whole.writeText(JSON.encodeToString(form, asked) + "\n")
        Files.move(whole, settingsFile, StandardCopyOption.REPLACE_EXISTING)
    }

    override fun close() {
        claim?.close()
        claim = null
    }

    private fun differences(present: Settings<P>, asked: Settings<P>): String = listOfNotNull(
        difference("the plan", "${present.plan}".lowercase(), "${asked.plan}".lowercase()),
        difference("the seed", present.seed, asked.seed),
        difference("the slowdown", present.slowdown, asked.slowdown),
        difference("the port", present.port ?: "none", asked.port ?: "none"),
    ).joinToString()

    private fun difference(what: String, present: Any, asked: Any) =
        if (present == asked) null else "$what is $present there and $asked was asked for"

    fun file(id: String): Path = runs.resolve("$id.jsonl")

    private fun records(): List<Path> = if (runs.exists()) runs.listDirectoryEntries("*.jsonl") else emptyList()

    fun finished(): List<R> = records().mapNotNull(read)

    fun unusable(): Int = records().size - finished().size
}

/**
 * Locks the [directory] of an experiment. The lock lasts until the returned channel is closed. The operating system also releases the lock
 * when the program ends.
 *
 * @throws ContinuationException if another experiment holds the lock
 */
private fun claim(directory: Path): FileChannel {
    // No other code may open this file, since closing it would release the lock.
    val channel = FileChannel.open(directory.resolve(".lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE)
    val lock = try {
        channel.tryLock()
    } catch (_: OverlappingFileLockException) {
        null // another experiment of this program holds the lock
    }
    if (lock != null) return channel
    channel.close()
    throw ContinuationException(
        "an experiment is being made in $directory right now; wait for its end, or choose another directory with --out",
    )
}
