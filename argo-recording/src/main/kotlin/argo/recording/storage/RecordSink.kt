package argo.recording.storage

import java.util.concurrent.ConcurrentHashMap

/**
 * Takes the records of a recording. Any thread may call the functions. Only [flush] and [close] wait for a disk, so reasoning and sensing
 * threads may call all other functions. Records offered by one thread are stored in their order. Records wait in memory for the recording's
 * own writing thread.
 */
abstract class RecordSink internal constructor(maxWaitingBytes: Long) : AutoCloseable {
    private val channels = ConcurrentHashMap<String, RecordChannel>()
    internal val waiting = WaitingRecords(maxWaitingBytes)

    /** The reason why storing has ended before [close], in words; null if it has not ended. */
    @Volatile
    var trouble: String? = null
        private set

    /**
     * Returns a channel for messages in JSON. For a known topic, returns its existing channel.
     *
     * @param topic the channel's name, such as `/robot/cycle`
     * @param schemaName the name of the messages' schema, such as `argo.Cycle`
     */
    fun channel(topic: String, schemaName: String, jsonSchema: String): RecordChannel =
        channels.computeIfAbsent(topic) { RecordChannel(topic, schemaName, jsonSchema) }

    /**
     * Offers a message for storing.
     *
     * @param timeNs the time of the message, in ns since 1970, or on another clock that all messages share; not below 0
     * @param data the message's JSON in UTF-8; do not change it afterwards
     * @return false if there is no room for the message, or if storing has ended. The recording then has a gap, and reports the gap itself
     */
    fun offer(channel: RecordChannel, timeNs: Long, data: ByteArray): Boolean = offer(channel, timeNs, data.size) { data }

    /**
     * Offers a message for storing, like the other [offer], but another thread makes its JSON.
     *
     * @param bytes the approximate size of the message in memory until its JSON is made
     * @param beside makes further messages later, which follow this one
     * @param encode makes the JSON later, from objects that do not change. If [encode] or [beside] throws, the message becomes a gap
     */
    fun offer(
        channel: RecordChannel,
        timeNs: Long,
        bytes: Int,
        beside: () -> List<Encoded> = ::emptyList,
        encode: () -> ByteArray,
    ): Boolean {
        require(timeNs >= 0) { "a time before 0: $timeNs" }
        return waiting.offer(Waiting.Message(channel, timeNs, bytes, beside, encode))
    }

    /** Adds a file, such as a program's text. A file is never dropped. */
    fun attach(name: String, mediaType: String, data: ByteArray) {
        waiting.add(Waiting.Attachment(name, mediaType, data))
    }

    /** Adds names and values under [name], such as versions. Metadata are never dropped. */
    fun metadata(name: String, values: Map<String, String>) {
        waiting.add(Waiting.Metadata(name, values))
    }

    /** Waits until everything offered before is stored, or until storing has ended. */
    fun flush() = waiting.flush()

    /** Refuses all later records, since nothing more can be stored. Passes [sentence], which reports this, to [warn]. */
    internal fun giveUp(sentence: String, warn: (String) -> Unit) {
        trouble = sentence
        warn(sentence)
        waiting.giveUp()
    }

    /**
     * Lets [worker] store the waiting records, and waits until it has ended. Jason interrupts the thread of an agent that it stops. The
     * calling thread still waits, so that the recording is complete, and is interrupted afterwards.
     */
    internal fun closeAndAwait(worker: Thread) {
        waiting.close()
        var isInterrupted = false
        while (worker.isAlive) {
            try {
                worker.join()
            } catch (_: InterruptedException) {
                isInterrupted = true
            }
        }
        if (isInterrupted) Thread.currentThread().interrupt()
    }

    /** Stores everything offered before, and ends the recording. Records offered afterwards are not stored. May be called twice. */
    abstract override fun close()
}

/** A message of [channel] at [timeNs] in ns, with the bytes of its JSON in UTF-8. */
class Encoded(val channel: RecordChannel, val timeNs: Long, val data: ByteArray)

class RecordChannel internal constructor(val topic: String, internal val schemaName: String, internal val jsonSchema: String)
