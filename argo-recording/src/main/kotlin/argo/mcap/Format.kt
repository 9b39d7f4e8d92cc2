package argo.mcap

/** The bytes with which a file begins and ends. The sixth byte is the version of the format. */
internal val MAGIC = byteArrayOf(0x89.toByte()) + "MCAP0\r\n".encodeToByteArray()

internal const val VERSION_AT = 5

/** The kinds of records. A record begins with its kind in one byte. */
internal object Op {
    const val HEADER = 0x01
    const val FOOTER = 0x02
    const val SCHEMA = 0x03
    const val CHANNEL = 0x04
    const val MESSAGE = 0x05
    const val CHUNK = 0x06
    const val MESSAGE_INDEX = 0x07
    const val CHUNK_INDEX = 0x08
    const val ATTACHMENT = 0x09
    const val ATTACHMENT_INDEX = 0x0A
    const val STATISTICS = 0x0B
    const val METADATA = 0x0C
    const val METADATA_INDEX = 0x0D
    const val SUMMARY_OFFSET = 0x0E
    const val DATA_END = 0x0F
}

/** The bytes before a record's content: its kind, and the length of the content. */
internal const val RECORD_HEAD_BYTES = 9

internal const val FOOTER_BYTES = 20
