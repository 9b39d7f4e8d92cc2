package argo.recording.storage

/**
 * Takes the records of a recording. Threads that reason and sense call it, so only [flush] and [close] wait for a disk. Any thread may
 * call; records offered by one thread are stored in their order.
 */
interface RecordSink : AutoCloseable {
    /**
     * Returns a channel for messages in JSON; for a known topic, the channel that was returned before.
     *
     * @param topic the channel's name, such as `/robot/cycle`
     * @param schemaName the name of the messages' schema, such as `argo.Cycle`
     * @param jsonSchema the schema, of JSON Schema
     */
    fun channel(topic: String, schemaName: String, jsonSchema: String): RecordChannel

    /**
     * Leaves a message to be stored.
     *
     * @param timeNs the time of the message, in ns, since 1970 or of another clock that is the same for all messages; not below 0
     * @param data the message's JSON in UTF-8; not to be changed afterwards
     * @return false if there is no room for the message, or storing has ended; then the recording has a gap, which it reports itself
     */
    fun offer(channel: RecordChannel, timeNs: Long, data: ByteArray): Boolean = offer(channel, timeNs, data.size) { data }

    /**
     * Leaves a message to be stored, as the other [offer] does, but another thread makes its JSON.
     *
     * @param bytes the approximate size that the message takes in memory until its JSON is made
     * @param encode makes the JSON later, from objects that do not change; if it throws, the message becomes a gap
     */
    fun offer(channel: RecordChannel, timeNs: Long, bytes: Int, encode: () -> ByteArray): Boolean

    /** Leaves a file to be stored, such as a program's text. It is never dropped. */
    fun attach(name: String, mediaType: String, data: ByteArray)

    /** Leaves names and values to be stored under [name], such as versions. They are never dropped. */
    fun metadata(name: String, values: Map<String, String>)

    /** The reason why storing has ended before [close], a sentence for a person; null: it has not. */
    val trouble: String?

    /** Waits until everything offered before is stored, or storing has ended. */
    fun flush()

    /** Stores everything offered before, and ends the recording. May be called twice; later records are not stored. */
    override fun close()
}

/** A channel of a [RecordSink], by its [topic]. */
class RecordChannel internal constructor(val topic: String, internal val schemaName: String, internal val jsonSchema: String)
