package samples.experiment

import kotlinx.serialization.SerializationException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists
import kotlin.io.path.extension
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** An experiment cannot be continued as asked; [message] says why and what to do. */
internal class ContinuationException(message: String) : Exception(message)

/** The directory that an experiment keeps its settings and its records in: `settings.json` and `runs/`. */
internal class Archive(val directory: Path) {
    private val settingsFile = directory.resolve("settings.json")
    private val runs = directory.resolve("runs")

    /** The settings of the experiment that is here, or null if none has been begun. */
    fun settings(): Settings? {
        if (!settingsFile.exists()) return null
        return try {
            JSON.decodeFromString(Settings.serializer(), settingsFile.readText())
        } catch (damaged: SerializationException) {
            throw ContinuationException("$settingsFile cannot be read (${damaged.message?.lineSequence()?.first()}); choose another directory with --out, or delete it")
        }
    }

    /**
     * Begins an experiment with [asked] here, or continues the one there is.
     *
     * @throws ContinuationException if that one has other settings
     */
    fun open(asked: Settings) {
        val present = settings()
        if (present != null && present != asked) throw ContinuationException(
            "$directory holds an experiment with other settings: ${differences(present, asked)}. Continue it with its own, or choose another directory with --out",
        )
        Files.createDirectories(runs)
        if (present == null) settingsFile.writeText(JSON.encodeToString(Settings.serializer(), asked) + "\n")
    }

    private fun differences(present: Settings, asked: Settings): String = listOfNotNull(
        difference("the plan", present.plan.name.lowercase(), asked.plan.name.lowercase()),
        difference("the seed", present.seed, asked.seed),
        difference("the slowdown", present.slowdown, asked.slowdown),
        difference("the port", present.port ?: "none", asked.port ?: "none"),
    ).joinToString()

    private fun difference(what: String, present: Any, asked: Any) = if (present == asked) null else "$what is $present there and $asked was asked for"

    /** Where the record of [trial] is, or will be. */
    fun file(trial: Trial): Path = runs.resolve("${trial.id}.jsonl")

    /** The runs that are over, in no order. Records that are not whole are deleted: their runs have to be made anew. */
    fun finished(): List<Finished> {
        if (!runs.exists()) return emptyList()
        return runs.listDirectoryEntries().filter { it.extension == "jsonl" }.mapNotNull { file ->
            val record = readRecord(file)
            val trial = (record?.first() as Entry.Begin?)?.trial
            if (record == null || trial?.id != file.nameWithoutExtension) null.also { file.deleteIfExists() }
            else Finished(trial, record.last() as Entry.Result)
        }
    }
}
