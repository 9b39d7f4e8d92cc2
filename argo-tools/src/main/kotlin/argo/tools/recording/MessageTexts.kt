package argo.tools.recording

import argo.mcap.McapChannel
import argo.mcap.McapException
import argo.mcap.McapMessage
import argo.mcap.RosMessages

/** Returns the texts of messages. A ROS 2 message becomes JSON. [problems] has a sentence for each reason why messages cannot be read. */
internal class MessageTexts {
    private val found = LinkedHashSet<String>()
    private val types = HashMap<McapChannel, RosMessages?>() // null if the channel has no ROS 2 messages, or unreadable ones

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
