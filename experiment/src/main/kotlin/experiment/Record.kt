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

/** A line of a run's record. Times are ns since the run began, by a steady clock. Distances are in cm. */
@Serializable
internal sealed interface Entry {
    /** The first line: the run, and its [settings]. */
    @Serializable
    @SerialName("trial")
    data class Begin(val trial: Trial, val settings: Settings<Plan>) : Entry

    /** The board began to send its percepts [text]. [distance] is the robot's true distance from the wall; null: not known. */
    @Serializable
    @SerialName("frame")
    data class Frame(val nanos: Long, val text: String, val distance: Double?) : Entry

    /** The command [text] took effect on the board. */
    @Serializable
    @SerialName("command")
    data class Command(val nanos: Long, val text: String, val distance: Double?) : Entry

    /** The agent began to believe the front distance [front], while [events] events and [intentions] intentions remained. */
    @Serializable
    @SerialName("belief")
    data class Belief(val nanos: Long, val front: Double?, val events: Int, val intentions: Int) : Entry

    /** The last line. */
    @Serializable
    @SerialName("result")
    data class Result(
        val outcome: Outcome,
        /** The final distance of the robot from the wall; 0 if it ran into the wall. */
        val distance: Double,
        /**
         * The time from crossing the limit to the stop or the wall, in ms. For a real robot this is an estimate, see [Sighting.crossed].
         */
        val sinceLimitMs: Double = 0.0,
        /**
         * The time from the first believed reading at or below the limit to the stop or the wall, in ms. Negative: the board had stopped
         * the robot before the agent believed the reading. Null: the agent believed no such reading.
         */
        val sincePerceivingMs: Double? = null,
        /** The number of commands that took effect; 0 for a real robot. */
        val commands: Int = 0,
        /** The number of the board's answers; 0 for a real robot. */
        val frames: Int = 0,
        /** The longest delay of this machine in the run, in ms; 0 for a real robot. */
        val lateMs: Double = 0.0,
        /** For [Outcome.IDLE] and [Outcome.FAILED]: the reason why nothing was measured. */
        val reason: String? = null,
    ) : Entry
}

/** The end of a run. */
@Serializable
internal enum class Outcome {
    @SerialName("stopped")
    STOPPED,

    @SerialName("collided")
    COLLIDED,

    /** The robot never drove, since no command to drive reached its board. */
    @SerialName("idle")
    IDLE,

    /** Nothing was measured, since the agent or its board failed. */
    @SerialName("failed")
    FAILED,
}

internal val JSON = Json { encodeDefaults = true }

/**
 * Writes the record of one run to [file], line by line. Safe on any thread. Overwrites an existing file.
 *
 * An agent and its board write in the middle of a run, so [write] throws nothing if the disk is full. The record then ends, and
 * [requireWhole] throws the cause.
 */
internal class RecordWriter(private val file: Path) : AutoCloseable {
    private val lock = ReentrantLock()
    private val out = Files.newOutputStream(file) // not buffered: a line that could not be written must not be written later
    private var isEnded = false
    private var trouble: IOException? = null

    /**
     * Adds [entry] as one whole line. Adds nothing after the result, after [close] or after a failed line, since a board may still answer
     * when its run is over.
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
     * @throws IOException if a line is missing; the exception has the cause
     */
    fun requireWhole() = lock.withLock { trouble?.let { throw IOException("$file cannot be written: ${it.message}", it) } }

    override fun close() = lock.withLock {
        isEnded = true
        out.close()
    }
}

/** Reads the record in [file]; null if the record is incomplete or a line of it is damaged. */
internal fun readRecord(file: Path): List<Entry>? {
    val entries = try {
        Files.readAllLines(file).map { JSON.decodeFromString(Entry.serializer(), it) }
    } catch (_: SerializationException) {
        return null // the line is cut off, or another version of this program wrote it
    } catch (_: java.nio.charset.CharacterCodingException) {
        return null
    }
    return entries.takeIf { it.firstOrNull() is Entry.Begin && it.lastOrNull() is Entry.Result }
}

internal data class Finished(val trial: Trial, val result: Entry.Result) {
    val isMeasured: Boolean get() = result.outcome == Outcome.STOPPED || result.outcome == Outcome.COLLIDED
}
