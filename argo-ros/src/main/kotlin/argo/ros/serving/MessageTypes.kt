package argo.ros.serving

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** The types of the topics and services here, described as the node `rosapi` does. */
internal object MessageTypes {
    private class Field(val name: String, val type: String, val isArray: Boolean)

    private val TYPES: Map<String, List<Field>> = mapOf(
        BOOL to "bool data",
        NUMBER to "float64 data",
        STRING to "string data",
        NUMBERS to "std_msgs/MultiArrayLayout layout, float64[] data",
        "std_msgs/MultiArrayLayout" to "std_msgs/MultiArrayDimension[] dim, uint32 data_offset",
        "std_msgs/MultiArrayDimension" to "string label, uint32 size, uint32 stride",
        "std_msgs/Header" to "uint32 seq, time stamp, string frame_id",
        "actionlib_msgs/GoalID" to "time stamp, string id",
        "actionlib_msgs/GoalStatus" to "actionlib_msgs/GoalID goal_id, uint8 status, string text",
        "actionlib_msgs/GoalStatusArray" to "std_msgs/Header header, actionlib_msgs/GoalStatus[] status_list",
        "argo_msgs/CommandActionResult" to
            "std_msgs/Header header, actionlib_msgs/GoalStatus status, argo_msgs/CommandResult result",
        "argo_msgs/CommandResult" to "bool success, string message",
        "${Graph.TRIGGER_TYPE}Request" to "",
        "${Graph.TRIGGER_TYPE}Response" to "bool success, string message",
        "${Graph.COMMAND_TYPE}Request" to "string[] arguments",
        "${Graph.COMMAND_TYPE}Response" to "bool success, string message",
        "${Graph.ACT_TYPE}Request" to "string command",
        "${Graph.ACT_TYPE}Response" to "bool success, string message",
    ).mapValues { (_, text) -> text.split(", ").filter { it.isNotEmpty() }.map(::fieldOf) }

    private fun fieldOf(text: String): Field {
        val (type, name) = text.split(' ')
        return Field(name, type.removeSuffix("[]"), type.endsWith("[]"))
    }

    /** Returns the descriptions of [type] and of the types of its fields. */
    fun details(type: String): JsonArray = JsonArray(withParts(type).map { (name, fields) -> typedef(name, fields) })

    /** Returns [type] as its file would have it. */
    fun textOf(type: String): String = withParts(type).entries.joinToString("") { (name, fields) ->
        val head = if (name == type) "" else "================\nMSG: $name\n"
        head + fields.joinToString("") { "${it.type}${if (it.isArray) "[]" else ""} ${it.name}\n" }
    }

    private fun withParts(type: String, found: MutableMap<String, List<Field>> = LinkedHashMap()): Map<String, List<Field>> {
        val fields = TYPES[type] ?: return found
        if (found.put(type, fields) == null) fields.forEach { withParts(it.type, found) }
        return found
    }

    private fun typedef(type: String, fields: List<Field>) = JsonObject(
        mapOf(
            "type" to JsonPrimitive(type),
            "fieldnames" to texts(fields.map { it.name }),
            "fieldtypes" to texts(fields.map { it.type }),
            "fieldarraylen" to JsonArray(fields.map { JsonPrimitive(if (it.isArray) 0 else -1) }),
            "examples" to texts(fields.map { exampleOf(it) }),
            "constnames" to texts(emptyList()),
            "constvalues" to texts(emptyList()),
        ),
    )

    private fun exampleOf(field: Field) = when {
        field.isArray -> "[]"
        field.type == "string" -> ""
        field.type == "bool" -> "False"
        field.type in TYPES -> "{}"
        else -> "0"
    }

    private fun texts(values: List<String>) = JsonArray(values.map { JsonPrimitive(it) })
}
