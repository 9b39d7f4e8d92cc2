package argo.ros.bridge

import argo.mcap.McapChannel
import argo.mcap.McapException
import argo.mcap.McapMessage
import argo.mcap.McapReader
import argo.mcap.RosField
import argo.mcap.RosMessages
import argo.mcap.RosType
import argo.ros.mapping.rosType
import javino.NoSuchPortException
import javino.PortFaultException
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.io.IOException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * A ROS 2 bag in the MCAP format. Describes its types as `rosapi` does. Only one thread at a time may read messages.
 *
 * @throws McapException if [path] is no MCAP file, or has no ROS 2 topics
 * @throws java.io.IOException if [path] cannot be read
 */
internal class Bag(path: Path) : AutoCloseable {
    private val reader = McapReader(path)
    private val channels = reader.channels.associateBy { it.topic }
    private val readers = reader.channels.associate { it.id to runCatching { readerOf(it) } }
    private val types = readers.values.mapNotNull { it.getOrNull() }.associateBy { it.types.first().name }

    init {
        if (types.isEmpty()) {
            val why = readers.values.firstNotNullOfOrNull { it.exceptionOrNull()?.message } ?: "it has no topics"
            reader.close()
            throw McapException("$path is no bag of ROS 2 that can be read here: $why")
        }
    }

    /** One sentence for each unreadable part of the file. */
    val problems: List<String> get() = reader.problems

    /** Returns the messages in file order. The number is the time since the earliest message, in ns. */
    fun messages(): Iterator<Pair<Long, McapMessage>> {
        val begin = reader.times?.first ?: 0
        return reader.messages().map { it.logTimeNs - begin to it }.iterator()
    }

    /**
     * Returns [message] in the JSON form of a bridge.
     *
     * @throws McapException if the message cannot be read
     */
    fun read(message: McapMessage): JsonObject = readers.getValue(message.channel.id).getOrThrow().read(message.data)

    private fun readerOf(channel: McapChannel) = RosMessages.of(channel)
        ?: throw McapException("${channel.topic} is in the encoding ${channel.messageEncoding}, and messages of ROS 2 are in cdr")

    /** Returns the type of [topic], or an empty text if the bag has no such topic. */
    fun typeOf(topic: String): String = channels[topic]?.schema?.name.orEmpty()

    fun answer(service: String, arguments: JsonObject): JsonObject? = when (service) {
        "/rosapi/topic_type" -> JsonObject(mapOf("type" to JsonPrimitive(typeOf(arguments.text("topic").orEmpty()))))
        "/rosapi/publishers" -> JsonObject(mapOf("publishers" to words(listOfNotNull(channels[arguments.text("topic")]?.let { "bag" }))))
        "/rosapi/message_details" -> types[rosType(arguments.text("type").orEmpty())]?.let { description(it.types) }
        else -> null
    }

    private fun description(types: List<RosType>) = JsonObject(mapOf("typedefs" to JsonArray(types.map(::definition))))

    private fun definition(type: RosType) = JsonObject(
        mapOf(
            "type" to JsonPrimitive(type.name),
            "fieldnames" to words(type.fields.map(RosField::name)),
            "fieldtypes" to words(type.fields.map(RosField::type)),
            "fieldarraylen" to JsonArray(type.fields.map { JsonPrimitive(it.length) }),
            "constnames" to words(type.constants.keys),
            "constvalues" to words(type.constants.values),
        ),
    )

    private fun words(texts: Collection<String>): JsonElement = JsonArray(texts.map(::JsonPrimitive))

    override fun close() = reader.close()

    companion object {
        private const val ENDINGS = "mcap|db3|bag|zstd"
        private val PORT = Regex("replay:(.+\\.(?:$ENDINGS)|[^#]+)(?:#.*)?")
        private val ENDED = Regex(".*\\.(?:$ENDINGS)")

        /**
         * Returns what stands behind `replay:` in [port], if it has an ending of recorded ROS data or is a folder. A folder, a missing file
         * and other formats are refused only by [open]. Returns null for other ports, as for a recording of a line.
         */
        fun fileIn(port: String): String? =
            PORT.matchEntire(port)?.groupValues?.get(1)?.takeIf { ENDED.matches(it) || pathOf(it)?.let(Files::isDirectory) == true }

        /** @throws javino.PortException if [file] cannot be read as a bag */
        fun open(port: String, file: String): Bag {
            val path = pathOf(file) ?: throw NoSuchPortException(port, "there is no bag $file in ${Path.of("").toAbsolutePath()}")
            if (Files.isDirectory(path)) throw NoSuchPortException(port, "$file is a folder; the bag is the file in it that ends in .mcap")
            return try {
                Bag(path)
            } catch (unreadable: IOException) {
                throw PortFaultException(port, "port $port cannot be opened: ${unreadable.message}", unreadable)
            }
        }

        private fun pathOf(file: String): Path? = try {
            Path.of(file).takeIf(Files::exists)
        } catch (_: InvalidPathException) {
            null
        }
    }
}
