package argo.tools.recording

import argo.mcap.McapChannel
import argo.mcap.McapException
import argo.mcap.McapMessage
import argo.mcap.RosMessages

/** Returns the texts of messages, as JSON for those of ROS 2. [problems] has a sentence for each reason why some cannot be read. */
internal class MessageTexts {
    private val found = LinkedHashSet<String>()
    private val types = HashMap<McapChannel, RosMessages?>() // null: the channel's messages are not of ROS 2, or cannot be read

    val problems: Set<String> get() = found

    fun of(message: McapMessage): String {
        val type = types.getOrPut(message.channel) { typeOf(message.channel) } ?: return message.text
        return try {
            "${type.read(message.data)}"
        } catch (unreadable: McapException) {
            found += "messages of ${message.channel.topic} are left out: ${unreadable.message}"
            "(${message.data.size} bytes)"
        }
    }

    private fun typeOf(channel: McapChannel): RosMessages? = try {
        RosMessages.of(channel)
    } catch (unreadable: McapException) {
        found += "messages of ${channel.topic} are shown as they are: ${unreadable.message}"
        null
    }
}
