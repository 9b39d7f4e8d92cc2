package argo.recording

import argo.mcap.McapReader
import argo.recording.storage.RecordingRing
import java.nio.file.Path
import java.time.Duration

/**
 * What a ring of the [last] of the recording [file] holds at its end, in a file beside it.
 *
 * @param kept a message as it is kept, by its topic and its text; null: it is not
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
