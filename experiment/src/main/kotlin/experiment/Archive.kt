package experiment

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
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * The settings of all runs of an experiment. A continued experiment must have the same.
 *
 * @property seed the seed of the order of the runs and of the noise of the sensors
 * @property slowdown the factor by which the agents reason more slowly than this computer
 * @property computer the calibration behind [slowdown], in words
 * @property port the port of a real robot, null for simulated ones
 */
@Serializable
internal data class Settings(val plan: Plan, val seed: Long, val slowdown: Double, val computer: String, val port: String? = null)

/** An experiment cannot be continued; [message] gives the reason and the remedy. */
internal class ContinuationException(message: String) : Exception(message)

/**
 * The directory with the settings and the records of an experiment: `settings.json` and `runs/`. From [open] to [close] it belongs to only
 * one experiment, among all programs.
 */
internal class Archive(val directory: Path) : AutoCloseable {
    private val settingsFile = directory.resolve("settings.json")
    private val runs = directory.resolve("runs")
    private var claim: FileChannel? = null

    /** Returns the settings of the experiment that is here, or null if none has been begun. */
    fun settings(): Settings? {
        if (!settingsFile.exists()) return null
        return try {
            JSON.decodeFromString(Settings.serializer(), settingsFile.readText())
        } catch (damaged: SerializationException) {
            throw ContinuationException(
                "$settingsFile cannot be read (${damaged.message?.lineSequence()?.first()}); " +
                    "choose another directory with --out, or delete it",
            )
        }
    }

    /**
     * Begins an experiment with [asked] here, or continues the one that is here.
     *
     * @throws ContinuationException if the one here has other settings, or is being made by another program
     * @throws IOException if the directory cannot be written to
     */
    fun open(asked: Settings) {
        Files.createDirectories(runs)
        if (claim == null) claim = claimed()
        val present = settings()
        if (present != null && present != asked) throw ContinuationException(
            "$directory holds an experiment with other settings: ${differences(present, asked)}. Continue it with its own, or choose " +
                "another directory with --out",
        )
        if (present == null) begin(asked)
    }

    /** Locks the directory; the operating system ends the lock with the program, however that ends. */
    private fun claimed(): FileChannel {
        // no other code opens this file: closing it would end the lock
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

    /** Writes all settings or none: a program that is killed meanwhile leaves no half of the settings. */
    private fun begin(asked: Settings) {
        val whole = settingsFile.resolveSibling("settings.json.new")
        whole.writeText(JSON.encodeToString(Settings.serializer(), asked) + "\n")
        Files.move(whole, settingsFile, StandardCopyOption.REPLACE_EXISTING)
    }

    override fun close() {
        claim?.close()
        claim = null
    }

    private fun differences(present: Settings, asked: Settings): String = listOfNotNull(
        difference("the plan", present.plan.name.lowercase(), asked.plan.name.lowercase()),
        difference("the seed", present.seed, asked.seed),
        difference("the slowdown", present.slowdown, asked.slowdown),
        difference("the port", present.port ?: "none", asked.port ?: "none"),
    ).joinToString()

    private fun difference(what: String, present: Any, asked: Any) =
        if (present == asked) null else "$what is $present there and $asked was asked for"

    /** Returns the file of the record of [trial], which may not exist yet. */
    fun file(trial: Trial): Path = runs.resolve("${trial.id}.jsonl")

    private fun records(): List<Path> = if (runs.exists()) runs.listDirectoryEntries("*.jsonl") else emptyList()

    /** Returns the runs that are over, in no order. Records that are not whole do not count: their runs have to be made anew. */
    fun finished(): List<Finished> = records().mapNotNull { file ->
        val record = readRecord(file)
        val trial = (record?.first() as Entry.Begin?)?.trial
        if (record == null || trial?.id != file.nameWithoutExtension) null else Finished(trial, record.last() as Entry.Result)
    }

    /** Returns the number of records that do not count in [finished]. */
    fun unusable(): Int = records().size - finished().size
}
