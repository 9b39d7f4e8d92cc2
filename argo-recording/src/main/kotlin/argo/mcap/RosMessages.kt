package argo.mcap

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.math.BigInteger
import java.nio.BufferUnderflowException
import java.util.Base64

/**
 * Reads the messages of ROS 2 in a bag, which are in CDR. Returns them as JSON like a rosbridge does. `uint8[]` becomes text in base64, and
 * a number that is infinite or NaN becomes `null`. Immutable.
 *
 * @property types the type of the messages, followed by the types of the messages within them
 */
class RosMessages private constructor(val types: List<RosType>) {
    private val own = types.first()
    private val byName = types.associateBy { it.name }

    /**
     * Reads a message, which may be compressed by Zstandard.
     *
     * @throws McapException if [data] is no message of this type, or is a message that cannot be read here
     */
    fun read(data: ByteArray): JsonObject = try {
        Reading(CdrInput(if (Zstd.isIn(data)) Zstd.decompress(data) else data)).message(own, 0)
    } catch (_: BufferUnderflowException) {
        throw McapException("a message of ${own.name} ends within a field")
    }

    private inner class Reading(private val cdr: CdrInput) {
        private var values = 0

        fun message(type: RosType, depth: Int): JsonObject {
            if (depth > MAX_DEPTH) throw McapException("the type ${own.name} is nested too deep, or holds itself")
            if (type.fields.isEmpty()) cdr.skipByte() // an empty message has one byte
            return JsonObject(type.fields.associate { it.name to value(it, depth) })
        }

        private fun value(field: RosField, depth: Int): JsonElement {
            if (field.length == RosField.SINGLE) return item(field.type, depth)
            val length = if (field.length == RosField.OPEN) cdr.length() else cdr.requireRoom(field.length)
            if (field.isBytes) return JsonPrimitive(Base64.getEncoder().encodeToString(cdr.bytes(length)))
            return JsonArray((0 until length).map { item(field.type, depth) })
        }

        private fun item(type: String, depth: Int): JsonElement {
            if (++values > MAX_VALUES) throw McapException("a message of ${own.name} has more than $MAX_VALUES values")
            return when (type) {
                "bool" -> JsonPrimitive(cdr.u8() != 0)
                "byte", "char", "uint8" -> JsonPrimitive(cdr.u8())
                "int8" -> JsonPrimitive(cdr.u8().toByte())
                "int16" -> JsonPrimitive(cdr.at(Short.SIZE_BYTES).getShort())
                "uint16" -> JsonPrimitive(cdr.at(Short.SIZE_BYTES).getShort().toUShort().toInt())
                "int32" -> JsonPrimitive(cdr.at(Int.SIZE_BYTES).getInt())
                "uint32" -> JsonPrimitive(cdr.at(Int.SIZE_BYTES).getInt().toUInt().toLong())
                "int64" -> JsonPrimitive(cdr.at(Long.SIZE_BYTES).getLong())
                "uint64" -> JsonPrimitive(BigInteger(cdr.at(Long.SIZE_BYTES).getLong().toULong().toString()))
                "float32" -> number(cdr.at(Float.SIZE_BYTES).getFloat().toDouble())
                "float64" -> number(cdr.at(Double.SIZE_BYTES).getDouble())
                "string" -> JsonPrimitive(cdr.text())
                "wstring" -> throw McapException("${own.name} has a wstring, which each middleware of ROS 2 writes in its own way")
                else -> message(byName[type] ?: throw McapException("the bag does not describe the type $type"), depth + 1)
            }
        }

        private fun number(value: Double) = if (value.isFinite()) JsonPrimitive(value) else JsonNull
    }

    companion object {
        /**
         * The largest number of values of a message, without those in `uint8[]`. The limit prevents a damaged message from filling the
         * memory.
         */
        const val MAX_VALUES = 1_000_000

        private const val MAX_DEPTH = 50

        /**
         * Returns the reader for the messages of [channel]; null if they are not messages of ROS 2.
         *
         * @throws McapException if their type cannot be read
         */
        fun of(channel: McapChannel): RosMessages? {
            if (channel.messageEncoding != "cdr") return null
            val schema = channel.schema ?: throw McapException("the bag does not describe the type of ${channel.topic}")
            if (schema.encoding != "ros2msg") {
                throw McapException("the type of ${channel.topic} is described by ${schema.encoding}, and only ros2msg can be read here")
            }
            return RosMessages(rosTypesIn(schema))
        }
    }
}
