package argo.recording.storage

/**
 * A number of [messages] that were not stored, because the disk was too slow.
 *
 * @property fromNs the time of the first missing message
 * @property untilNs the time of the last missing message
 */
internal data class Gap(val messages: Long, val fromNs: Long, val untilNs: Long) {
    fun and(timeNs: Long) = Gap(messages + 1, minOf(fromNs, timeNs), maxOf(untilNs, timeNs))

    fun encoded() = Encoded(CHANNEL, untilNs, json())

    fun json(): ByteArray = """{"messages":$messages,"fromNs":$fromNs,"untilNs":$untilNs}""".encodeToByteArray()

    companion object {
        fun of(timeNs: Long) = Gap(1, timeNs, timeNs)

        val CHANNEL = RecordChannel(
            GAP_TOPIC, "argo.Gap",
            """
            {"type":"object","required":["messages","fromNs","untilNs"],
            "properties":{"messages":{"type":"integer"},"fromNs":{"type":"integer"},"untilNs":{"type":"integer"}}}
            """.trimIndent().replace("\n", ""),
        )
    }
}

/** The topic of the messages that replace gaps of a recording: `{"messages":12,"fromNs":…,"untilNs":…}`. */
const val GAP_TOPIC = "/recording/gap"
