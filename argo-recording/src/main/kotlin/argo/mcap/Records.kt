package argo.mcap

/**
 * How the messages of some channels are to be read.
 *
 * @property id its number in the file, from 1
 * @property name its name, such as `argo.Cycle`
 * @property encoding `jsonschema` in the files of [McapWriter]
 * @property text the schema, of JSON Schema in the files of [McapWriter]
 */
data class McapSchema(val id: Int, val name: String, val encoding: String, val text: String)

/**
 * A sequence of messages of one kind.
 *
 * @property id its number in the file
 * @property topic its name, such as `/robot/cycle`
 * @property schema how its messages are to be read; null: the file says nothing of that
 * @property messageEncoding `json` in the files of [McapWriter]
 * @property metadata what else the file says of it
 */
data class McapChannel(
    val id: Int,
    val topic: String,
    val schema: McapSchema?,
    val messageEncoding: String,
    val metadata: Map<String, String> = emptyMap(),
)

/**
 * One message of a channel.
 *
 * @property sequence counts the messages of the channel, from 0, in the files of [McapWriter]
 * @property logTimeNs when it was recorded, in ns; since 1970 where it is a time of day
 * @property publishTimeNs when it was made, on the same clock
 * @property data its bytes; not to be changed
 */
class McapMessage(val channel: McapChannel, val sequence: Long, val logTimeNs: Long, val publishTimeNs: Long, val data: ByteArray) {
    /** [data] as text in UTF-8, as of messages in JSON. */
    val text: String get() = data.decodeToString()

    override fun toString() = "${channel.topic} #$sequence @$logTimeNs: ${data.size} bytes"
}

/**
 * A file inside the file.
 *
 * @property mediaType what it is, such as `text/plain`
 * @property timeNs when it was recorded, on the clock of the messages
 */
class McapAttachment internal constructor(val name: String, val mediaType: String, val timeNs: Long, read: () -> ByteArray) {
    /** Its bytes; not to be changed. Read from the file at the first call, for which the reader is to be open. */
    val data: ByteArray by lazy(LazyThreadSafetyMode.NONE, read)

    /** [data] as text in UTF-8. */
    val text: String get() = data.decodeToString()

    override fun toString() = "$name ($mediaType)"
}

/** Names and values under a name, such as versions. */
data class McapMetadata(val name: String, val values: Map<String, String>)
