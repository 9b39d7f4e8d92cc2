package experiment.delegation

import experiment.ContinuationException
import experiment.JSON
import experiment.claim
import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.nio.file.StandardOpenOption.APPEND
import kotlin.io.path.exists
import kotlin.io.path.readLines
import kotlin.io.path.writeLines

/** The settings of all runs of an experiment, as for [experiment.Settings]. */
@Serializable
internal data class DelegationSettings(val plan: DelegationPlan, val seed: Long, val slowdown: Double, val computer: String)

@Serializable
internal data class Measured(val run: DelegationRun, val result: DelegationResult)

/**
 * The records of an experiment in [directory]: the settings in the first line of `runs.jsonl`, and each run in a line of its own. From
 * [open] to [close] only one experiment owns them. Safe on any thread.
 */
internal class DelegationRecords(val directory: Path) : AutoCloseable {
    private val file = directory.resolve("runs.jsonl")
    private val made = ArrayList<Measured>()
    private var claim: FileChannel? = null

    /** Returns the finished runs, in the order in which they were made. */
    val finished: List<Measured> @Synchronized get() = made.toList()

    /**
     * Returns the settings of the experiment in this directory; null: there is none.
     *
     * @throws ContinuationException if they cannot be read
     */
    fun settings(): DelegationSettings? = if (!file.exists()) null
    else file.readLines().firstOrNull()?.let { read(DelegationSettings.serializer(), it) }
        ?: throw ContinuationException("$file does not begin with settings; choose another directory with --out, or delete it")

    /**
     * Begins an experiment with these [settings], or continues it. Returns the number of damaged lines, whose runs have to be made anew.
     *
     * @throws ContinuationException if another experiment is being made in the directory
     * @throws java.io.IOException if the directory cannot be written to
     */
    fun open(settings: DelegationSettings): Int {
        Files.createDirectories(directory)
        claim = claim(directory)
        val lines = if (file.exists()) file.readLines().drop(1) else emptyList()
        made += lines.mapNotNull { read(Measured.serializer(), it) }
        val whole = file.resolveSibling("runs.jsonl.new") // a line that was cut off would spoil the next one
        whole.writeLines(listOf(line(DelegationSettings.serializer(), settings)) + made.map { line(Measured.serializer(), it) })
        Files.move(whole, file, StandardCopyOption.REPLACE_EXISTING)
        return lines.size - made.size
    }

    /** @throws java.io.IOException if the line cannot be written */
    @Synchronized
    fun add(measured: Measured) {
        Files.writeString(file, line(Measured.serializer(), measured) + "\n", APPEND)
        made += measured
    }

    override fun close() {
        claim?.close()
    }

    private fun <T> line(form: KSerializer<T>, value: T) = JSON.encodeToString(form, value)

    private fun <T : Any> read(form: KSerializer<T>, line: String): T? = try {
        JSON.decodeFromString(form, line)
    } catch (_: SerializationException) {
        null
    }
}
