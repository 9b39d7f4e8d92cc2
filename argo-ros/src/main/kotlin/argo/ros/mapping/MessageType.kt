package argo.ros.mapping

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.math.BigDecimal
import java.math.BigInteger
import java.util.Base64

/** A path leads to no field, or the field cannot have the value; [message] gives the reason. */
internal class Unfit(message: String) : Exception(message)

/**
 * The type of a field.
 *
 * @property name a ROS 1 or ROS 2 type, such as `float64`, `double` or `geometry_msgs/Vector3`
 * @property length the number of items of a list; [ANY] if it varies, [SINGLE] if the field is no list
 */
internal data class FieldType(val name: String, val length: Int) {
    /** True if bridges encode the field as base64 text. */
    val isBytes: Boolean get() = length != SINGLE && name in BYTES

    override fun toString() = name + if (length == SINGLE) "" else if (length == ANY) "[]" else "[$length]"

    companion object {
        const val SINGLE = -1
        const val ANY = 0
        private val BYTES = setOf("uint8", "char")
    }
}

/**
 * A message type that a robot has described, with all types that it contains. Immutable.
 *
 * @property name the type's name in the mapping
 * @property constants the constants of this type and of the types that it contains
 */
internal class MessageType private constructor(
    val name: String,
    private val own: String,
    private val types: Map<String, Map<String, FieldType>>,
    val constants: Map<String, JsonElement>,
) {
    /**
     * Returns the type of the field at [path].
     *
     * Returns null if the type around the field is not described, or if [path] names a constant.
     *
     * @throws Unfit if there is no such field
     */
    fun typeAt(path: Path): FieldType? {
        if (constantIn(path) in constants) return null
        var type = FieldType(own, FieldType.SINGLE)
        for ((index, step) in path.withIndex()) {
            val place = written(path.take(index))
            type = (if (step is Step.Name) fieldOf(type, step.name, place) else itemOf(type, step, place)) ?: return null
        }
        return if (path.any { it is Step.Sector }) FieldType(type.name, FieldType.ANY) else type
    }

    private fun itemOf(type: FieldType, step: Step, place: String): FieldType {
        if (type.length == FieldType.SINGLE) throw Unfit("$place of $name is a ${type.name}, and no list")
        val isThere = when {
            type.length == FieldType.ANY -> true
            step is Step.Item -> step.indexIn(type.length) in 0 until type.length
            else -> step is Step.Sector && step.indicesIn(type.length) != null
        }
        if (!isThere) throw Unfit("$place of $name has ${type.length} items, and no $step")
        return FieldType(type.name, FieldType.SINGLE)
    }

    private fun fieldOf(type: FieldType, step: String, place: String): FieldType? {
        val fields = types[type.name]
        return when {
            type.length != FieldType.SINGLE -> throw Unfit("$place of $name is a list; take an item of it, as $place[0].$step")
            fields != null -> fields[step] ?: throw Unfit(
                "${shownName(type)} has no field $step; it has ${(fields.keys + constants.keys).joinToString(", ")}",
            )
            '/' in type.name -> null
            else -> throw Unfit("$place of $name is a ${type.name}, and has no field $step")
        }
    }

    private fun shownName(type: FieldType) = if (type.name == own) name else type.name

    /** Returns the beginning of [path] that leads to a byte array, or null if there is none. */
    private fun bytesIn(path: Path): Path? = try {
        path.indices.map { path.take(it + 1) }.find { typeAt(it)?.isBytes == true }
    } catch (_: Unfit) {
        null // the wrong path was reported when the type was received
    }

    fun has(name: String): Boolean = types[own]?.containsKey(name) == true

    val fieldNames: Set<String> get() = types[own].orEmpty().keys

    /** Returns warnings about pose fields that stay empty if a message sets only [paths]. */
    fun emptyAmong(paths: List<Path>): List<String> = paths.flatMap { path -> path.indices.map(path::take) }.distinct()
        .flatMap { place -> emptyRotations(place, paths) + listOfNotNull(emptyFrame(place, paths)) }

    private fun emptyRotations(place: Path, paths: List<Path>): List<String> = fieldsAt(place)
        .filter { it.value == "geometry_msgs/Quaternion" }.map { place + Step.Name(it.key) }
        .filter { rotation -> paths.none { it.take(rotation.size) == rotation } }.map(::written)
        .map { "$it of $name is left as a quaternion of zeros, which is no rotation; for none, write $it.w = 1" }

    private fun emptyFrame(place: Path, paths: List<Path>): String? {
        val fields = fieldsAt(place)
        val frame = place + listOf(Step.Name("header"), Step.Name("frame_id"))
        if (fields["header"] != "std_msgs/Header" || fields.values.none(PLACED::contains) || frame in paths) return null
        return "${written(frame)} of $name is left empty, so that its frame is not known; write ${written(frame)} = 'map'"
    }

    private fun fieldsAt(place: Path): Map<String, String> =
        types[if (place.isEmpty()) own else typeAt(place)?.name].orEmpty().mapValues { it.value.name }

    fun bytesAmong(read: List<Expression.Field>): Set<Path> = read.mapNotNull { bytesIn(it.path) }.toSet()

    /**
     * Returns [value] in the form that the field at [path] needs.
     *
     * @throws Unfit if there is no such field, or if it cannot have [value]. ROS would drop the whole message.
     */
    fun fit(path: Path, value: JsonElement): JsonElement {
        val type = typeAt(path) ?: return value
        return try {
            fitted(value, type)
        } catch (unfit: Unfit) {
            throw Unfit("${written(path)} of $name is a $type: ${unfit.message}")
        }
    }

    /**
     * Checks that an argument of a command can be the value of the field at [path].
     *
     * @throws Unfit if there is no such field, or if the field is a message
     */
    fun requireNoMessage(path: Path) {
        val type = typeAt(path)?.takeIf { it.length == FieldType.SINGLE && isMessage(it) } ?: return
        throw Unfit("${written(path)} of $name is a $type, and no argument is a message; ${fieldsIn(type)}")
    }

    private fun isMessage(type: FieldType) = type.name !in TIMES && (type.name in types || '/' in type.name)

    private fun fieldsIn(type: FieldType) = "give its fields a value, ${types[type.name]?.keys.orEmpty().joinToString(", ")}"

    private fun fitted(value: JsonElement, type: FieldType): JsonElement = when {
        type.length != FieldType.SINGLE -> list(value, type)
        type.name in TIMES && value == NOW -> value
        type.name in types || '/' in type.name -> throw Unfit("$value is no message; ${fieldsIn(type)}")
        value !is JsonPrimitive -> throw Unfit("it takes no list, as $value is")
        type.name == "string" || type.name == "wstring" -> text(value)
        type.name == "bool" || type.name == "boolean" -> value.takeIf { isTruth(it) } ?: throw Unfit("$value is neither true nor false")
        type.name in FLOATS -> value.also { requireFloat(it, FLOATS.getValue(type.name)) }
        type.name in INTEGERS -> value.also { requireInteger(it, INTEGERS.getValue(type.name)) }
        else -> value
    }

    private fun list(value: JsonElement, type: FieldType): JsonElement {
        if (type.isBytes && value is JsonPrimitive && bytesOf(value) != null) return value
        if (value !is JsonArray) throw Unfit("$value is no list" + if (type.isBytes) ", nor bytes in base64" else "")
        val isFull = type.length == FieldType.ANY || value.size == type.length
        if (!isFull) throw Unfit("the list has ${value.size} items")
        return JsonArray(value.map { fitted(it, FieldType(type.name, FieldType.SINGLE)) })
    }

    private fun text(value: JsonPrimitive) = when {
        value.isString -> value
        isTruth(value) -> JsonPrimitive(value.content)
        else -> throw Unfit("$value is a number; write \"$value\"")
    }

    private fun isTruth(value: JsonPrimitive) = !value.isString && (value.content == "true" || value.content == "false")

    private fun requireFloat(value: JsonPrimitive, most: Double) {
        val number = numberIn(value) ?: throw Unfit("$value is no number")
        if (number.abs() > BigDecimal(most)) throw Unfit("$value is beyond its range")
    }

    private fun requireInteger(value: JsonPrimitive, range: ClosedRange<BigInteger>) {
        val number = numberIn(value) ?: throw Unfit("$value is no number")
        if (number.stripTrailingZeros().scale() > 0) throw Unfit("$value is no whole number; the mapping may round it")
        if (number.toBigInteger() !in range) throw Unfit("$value is not within ${range.start} to ${range.endInclusive}")
    }

    private fun numberIn(value: JsonPrimitive) = value.takeIf { !it.isString }?.content?.toBigDecimalOrNull()

    companion object {
        private val NOW = JsonPrimitive("now")
        private val PLACED = listOf("Pose", "PoseWithCovariance", "Point").map { "geometry_msgs/$it" }
        private val TIMES = setOf("time", "builtin_interfaces/Time")
        private val FLOATS = mapOf(
            "float32" to Float.MAX_VALUE.toDouble(), "float" to Float.MAX_VALUE.toDouble(),
            "float64" to Double.MAX_VALUE, "double" to Double.MAX_VALUE,
        )
        private val INTEGERS: Map<String, ClosedRange<BigInteger>> = listOf(8, 16, 32, 64).flatMap { bits ->
            val half = BigInteger.TWO.pow(bits - 1)
            listOf("int$bits" to -half..half - BigInteger.ONE, "uint$bits" to BigInteger.ZERO..half + half - BigInteger.ONE)
        }.toMap().let { it + mapOf("byte" to it.getValue("int8"), "char" to it.getValue("uint8"), "octet" to it.getValue("uint8")) }

        fun of(answer: JsonObject, name: String): MessageType? {
            val definitions = (answer["typedefs"] as? JsonArray).orEmpty().filterIsInstance<JsonObject>()
            val types = definitions.mapNotNull { definition -> definition.word("type")?.let { rosType(it) to fieldsOf(definition) } }
            val own = types.find { it.first == rosType(name) } ?: types.firstOrNull() ?: return null
            // the type's own constants come last and replace others
            val ownLast = definitions.sortedBy { rosType(it.word("type").orEmpty()) == own.first }
            return MessageType(name, own.first, types.toMap(), ownLast.flatMap(::constantsOf).toMap())
        }

        private fun constantsOf(definition: JsonObject): List<Pair<String, JsonElement>> =
            definition.words("constnames").zip(definition.words("constvalues")) { name, value ->
                name to (value.toBigDecimalOrNull()?.let { JsonPrimitive(it) } ?: JsonPrimitive(value))
            }

        private fun fieldsOf(definition: JsonObject): Map<String, FieldType> {
            val types = definition.words("fieldtypes")
            val lengths = definition.words("fieldarraylen")
            return definition.words("fieldnames").withIndex().associate { (index, field) ->
                val type = types.getOrElse(index) { "" }.substringBefore(',').substringBefore('<') // without the length limit of ROS 2
                val length = lengths.getOrNull(index)?.toIntOrNull() ?: FieldType.SINGLE
                field.removePrefix("_") to FieldType(rosType(type), length) // rosapi of ROS 2 adds a leading "_"
            }
        }

        private fun JsonObject.word(name: String) = (this[name] as? JsonPrimitive)?.content

        private fun JsonObject.words(name: String) = (this[name] as? JsonArray).orEmpty().map { (it as? JsonPrimitive)?.content.orEmpty() }
    }
}

/** Returns [type] without the `/msg` that ROS 2 adds. */
internal fun rosType(type: String) = type.replace("/msg/", "/")

/**
 * Decodes base64 text to a list of bytes. Returns other values unchanged. Returns null if the text is no base64, or has more than
 * [MAX_ITEMS] bytes.
 */
internal fun bytesOf(value: JsonElement): JsonElement? {
    if (value !is JsonPrimitive || !value.isString) return value
    if (value.content.length > MAX_BASE64) return null
    return try {
        JsonArray(Base64.getDecoder().decode(value.content).map { JsonPrimitive(it.toInt() and 0xFF) }).takeIf { it.size <= MAX_ITEMS }
    } catch (_: IllegalArgumentException) {
        null
    }
}

private const val MAX_BASE64 = (MAX_ITEMS + 2) / 3 * 4
