package argo.recording

import argo.mcap.McapReader
import argo.recording.storage.RecordingRing
import java.nio.file.Path
import java.time.Duration

/**
 * Writes a file beside the recording [file] with the messages of the [last] time. Returns the file.
 *
 * @param kept returns the text to keep of a message with this topic and text, or null to drop the message
 */
internal fun ringOf(file: Path, last: Duration, kept: (topic: String, text: String) -> String? = { _, text -> text }): Path {
    val saved = file.resolveSibling("ring-${file.fileName}")
    McapReader(file).use { whole ->
        RecordingRing(last).use { ring ->
            whole.attachments.forEach { ring.attach(it.name, it.mediaType, it.data) }
            whole.metadata.forEach { ring.metadata(it.name, it.values) }
            for (message in whole.messages()) {
                val topic = message.channel.topic
                val text = kept(topic, message.text) ?: continue
                ring.offer(ring.channel(topic, "argo", "{}"), message.logTimeNs, text.encodeToByteArray())
            }
            ring.save(saved)
        }
    }
    return saved
}
