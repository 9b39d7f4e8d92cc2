package argo.mcap

/**
 * The type of messages of ROS 2, as a bag describes it. Immutable.
 *
 * @property name the type's name without the `msg` between package and type, such as `sensor_msgs/Range`
 * @property constants the constants, with their values as text
 */
class RosType internal constructor(val name: String, val fields: List<RosField>, val constants: Map<String, String>)

/**
 * A field of a [RosType].
 *
 * @property type a built-in type such as `float32`, or the name of a [RosType]
 * @property length the number of items; [OPEN] if it varies, [SINGLE] if the field is no list
 */
class RosField internal constructor(val name: String, val type: String, val length: Int) {
    internal val isBytes: Boolean get() = length != SINGLE && type in BYTES

    companion object {
        const val SINGLE = -1
        const val OPEN = 0
        private val BYTES = setOf("uint8", "char")
    }
}

private val BUILT_IN = setOf("bool", "byte", "char", "float32", "float64", "string", "wstring") +
    listOf(8, 16, 32, 64).flatMap { listOf("int$it", "uint$it") }
private val DEPENDENCY = Regex("(?m)^={40,}\\s*\\R+MSG: *(\\S+)\\s*$")
private val CONSTANT = Regex("\\S+\\s+([A-Z][A-Z0-9_]*)\\s*=(.*)")
private val FIELD = Regex("([A-Za-z]\\w*(?:/\\w+)*)(?:<=\\d+)?(\\[(<=)?(\\d{0,9})])?\\s+([A-Za-z]\\w*)(\\s.*)?")

/**
 * Returns the types in [schema], which must have the encoding `ros2msg`. The first is the type of its messages. The types within it follow.
 *
 * @throws McapException if a line cannot be read
 */
internal fun rosTypesIn(schema: McapSchema): List<RosType> {
    val names = listOf(schema.name) + DEPENDENCY.findAll(schema.text).map { it.groupValues[1] }
    return names.zip(DEPENDENCY.split(schema.text)) { name, text -> rosTypeOf(bare(name), text) }
}

private fun bare(name: String) = name.replace("/msg/", "/")

private fun rosTypeOf(name: String, text: String): RosType {
    val lines = text.lines().map { it.trim() }.filterNot { it.startsWith('#') }
    val constants = lines.mapNotNull(CONSTANT::matchEntire).associate { it.groupValues[1] to constantIn(it.groupValues[2]) }
    val fields = lines.filterNot(CONSTANT::matches).map { it.substringBefore('#').trim() }.filter { it.isNotEmpty() }
    return RosType(name, fields.map { fieldOf(it, name.substringBefore('/')) }, constants)
}

private fun constantIn(text: String): String {
    val value = text.trim()
    val quote = value.firstOrNull()?.takeIf { it == '"' || it == '\'' } ?: return value.substringBefore('#').trim()
    return value.drop(1).substringBeforeLast(quote)
}

private fun fieldOf(line: String, pack: String): RosField {
    val (type, list, bound, count, name) = FIELD.matchEntire(line)?.destructured
        ?: throw McapException("\"${line.take(MAX_QUOTED)}\" is no field of a message of ROS")
    val length = when {
        list.isEmpty() -> RosField.SINGLE
        bound.isEmpty() && count.isNotEmpty() -> count.toInt()
        else -> RosField.OPEN
    }
    return RosField(name, if (type in BUILT_IN) type else if ('/' in type) bare(type) else "$pack/$type", length)
}

private const val MAX_QUOTED = 60
