package experiment

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** A line of a run's record. Times are ns since the start of the run, by a steady clock. Distances are in cm. */
@Serializable
internal sealed interface Entry {
    /** The first line: the run, and its [settings]. */
    @Serializable
    @SerialName("trial")
    data class Begin(val trial: Trial, val settings: Settings<Plan>) : Entry

    /** The board started to send its percepts [text]. [distance] is the robot's true distance from the wall, or null if it is not known. */
    @Serializable
    @SerialName("frame")
    data class Frame(val nanos: Long, val text: String, val distance: Double?) : Entry

    /** The command [text] took effect on the board. */
    @Serializable
    @SerialName("command")
    data class Command(val nanos: Long, val text: String, val distance: Double?) : Entry

    /** The agent started to believe the front distance [front]. At that time it had [events] events and [intentions] intentions. */
    @Serializable
    @SerialName("belief")
    data class Belief(val nanos: Long, val front: Double?, val events: Int, val intentions: Int) : Entry

    @Serializable
    @SerialName("result")
    data class Result(
        val outcome: Outcome,
        /** The final distance from the wall, or 0 after a collision. */
        val distance: Double,
        /**
         * The time from crossing the limit to the stop or the wall, in ms. For a real robot, the time is an estimate from
         * [Sighting.crossed].
         */
        val sinceLimitMs: Double = 0.0,
        /**
         * The time from the first believed reading at or below the limit to the stop or the wall, in ms. The time is negative if the board
         * stopped the robot before the agent believed the reading. The time is null if the agent believed no such reading.
         */
        val sincePerceivingMs: Double? = null,
        /** The number of commands that took effect, or 0 for a real robot. */
        val commands: Int = 0,
        /** The number of the board's answers, or 0 for a real robot. */
        val frames: Int = 0,
        /** The longest delay of this machine in the run in ms, or 0 for a real robot. */
        val lateMs: Double = 0.0,
        /** The reason why nothing was measured, for [Outcome.IDLE] and [Outcome.FAILED]. */
        val reason: String? = null,
    ) : Entry
}

@Serializable
internal enum class Outcome {
    @SerialName("stopped")
    STOPPED,

    @SerialName("collided")
    COLLIDED,

    /** The robot never drove. No command to drive reached its board. */
    @SerialName("idle")
    IDLE,

    /** Nothing was measured because the agent or its board failed. */
    @SerialName("failed")
    FAILED,
}

internal val JSON = Json { encodeDefaults = true }

/**
 * Writes the record of one run to [file], line by line. Safe for use by several threads. Overwrites an existing file.
 *
 * An agent and its board call [write] during a run. [write] therefore throws nothing if the disk is full. The record then ends, and
 * [requireWhole] throws the cause.
 */
internal class RecordWriter(private val file: Path) : AutoCloseable {
    private val lock = ReentrantLock()
    private val out = Files.newOutputStream(file) // unbuffered, so that a failed line is not written later
    private var isEnded = false
    private var trouble: IOException? = null

    /**
     * Adds [entry] as one whole line. Adds nothing after the result, after [close] or after a failed line. A board may still answer after
     * its run.
     */
    fun write(entry: Entry) = lock.withLock {
        if (!isEnded && trouble == null) {
            try {
                out.write((JSON.encodeToString(Entry.serializer(), entry) + "\n").toByteArray())
            } catch (full: IOException) {
                trouble = full
            }
        }
        if (entry is Entry.Result) isEnded = true
    }

    /**
     * Checks that all lines have been written.
     *
     * @throws IOException if a line is missing, with the cause
     */
    fun requireWhole() = lock.withLock { trouble?.let { throw IOException("$file cannot be written: ${it.message}", it) } }

    override fun close() = lock.withLock {
        isEnded = true
        out.close()
    }
}

/** Reads the record in [file], or returns null if it is incomplete or a line is damaged. */
internal fun readRecord(file: Path): List<Entry>? {
    val entries = try {
        Files.readAllLines(file).map { JSON.decodeFromString(Entry.serializer(), it) }
    } catch (_: SerializationException) {
        return null // the line is incomplete, or another version of this program wrote it
    } catch (_: java.nio.charset.CharacterCodingException) {
        return null
    }
    return entries.takeIf { it.firstOrNull() is Entry.Begin && it.lastOrNull() is Entry.Result }
}

internal data class Finished(val trial: Trial, val result: Entry.Result) {
    val isMeasured: Boolean get() = result.outcome == Outcome.STOPPED || result.outcome == Outcome.COLLIDED
}
