package experiment

import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * The settings of all runs of an experiment. A continued experiment must have the same settings.
 *
 * @property seed the seed of the order of the runs and of the noise of the sensors
 * @property slowdown the factor by which the agents reason more slowly than this computer
 * @property computer the calibration behind [slowdown], in words
 * @property port the port of a real robot; null for simulated robots
 */
@Serializable
internal data class Settings(val plan: Plan, val seed: Long, val slowdown: Double, val computer: String, val port: String? = null)

/** An experiment cannot be continued; [message] contains the reason and the remedy. */
internal class ContinuationException(message: String) : Exception(message)

/**
 * The directory with the settings and the records of an experiment: `settings.json` and `runs/`. From [open] to [close] only one experiment
 * of one program owns it.
 */
internal class Archive(val directory: Path) : AutoCloseable {
    private val settingsFile = directory.resolve("settings.json")
    private val runs = directory.resolve("runs")
    private var claim: FileChannel? = null

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
     * Begins an experiment with the settings [asked], or continues the experiment in this directory.
     *
     * @throws ContinuationException if the present experiment has other settings, or another program is making it
     * @throws IOException if the directory cannot be written to
     */
    fun open(asked: Settings) {
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

    /** Returns the file for the record of [trial], which may not exist yet. */
    fun file(trial: Trial): Path = runs.resolve("${trial.id}.jsonl")

    private fun records(): List<Path> = if (runs.exists()) runs.listDirectoryEntries("*.jsonl") else emptyList()

    /** Returns the finished runs, in no order. A run whose record is not whole has to be made anew. */
    fun finished(): List<Finished> = records().mapNotNull { file ->
        val record = readRecord(file)
        val trial = (record?.first() as Entry.Begin?)?.trial
        if (record == null || trial?.id != file.nameWithoutExtension) null else Finished(trial, record.last() as Entry.Result)
    }

    fun unusable(): Int = records().size - finished().size
}
