package argo.mcap

import java.io.IOException

/**
 * The schema of the messages of some channels.
 *
 * @property id the schema's number in the file, from 1
 * @property name the schema's name, such as `argo.Cycle`
 * @property encoding `jsonschema` in the files of [McapWriter]
 * @property text the schema itself
 */
data class McapSchema(val id: Int, val name: String, val encoding: String, val text: String)

/**
 * A sequence of messages of one kind.
 *
 * @property id the channel's number in the file
 * @property topic the channel's name, such as `/robot/cycle`
 * @property schema the schema of the channel's messages; null if the file has no schema for the channel
 * @property messageEncoding `json` in the files of [McapWriter]
 * @property metadata further names and values of the channel
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
 * @property sequence the number of the message in its channel, from 0, in the files of [McapWriter]
 * @property logTimeNs the time of recording, in ns; since 1970 if it is a time of day
 * @property publishTimeNs the time at which the message was made, on the clock of [logTimeNs]
 * @property data the message's bytes; do not change them
 */
class McapMessage(val channel: McapChannel, val sequence: Long, val logTimeNs: Long, val publishTimeNs: Long, val data: ByteArray) {
    /** [data] as text in UTF-8. */
    val text: String get() = data.decodeToString()

    override fun toString() = "${channel.topic} #$sequence @$logTimeNs: ${data.size} bytes"
}

/**
 * A file inside the MCAP file.
 *
 * @property mediaType the file's media type, such as `text/plain`
 * @property timeNs the time of recording, on the clock of the messages
 */
class McapAttachment internal constructor(val name: String, val mediaType: String, val timeNs: Long, read: () -> ByteArray) {
    /** The file's bytes; do not change them. The first call reads the bytes, and needs an open reader. */
    val data: ByteArray by lazy(LazyThreadSafetyMode.NONE, read)

    /** [data] as text in UTF-8. */
    val text: String get() = data.decodeToString()

    override fun toString() = "$name ($mediaType)"
}

/** Named values, such as versions, under a common name. */
data class McapMetadata(val name: String, val values: Map<String, String>)

/** Reports that a file cannot be read as MCAP, or contains something that this version cannot read. */
class McapException(message: String) : IOException(message)
