package argo.recording

import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerialInfo
import kotlinx.serialization.descriptors.PrimitiveKind
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.descriptors.StructureKind
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray
import kotlinx.serialization.json.putJsonObject
import java.util.concurrent.ConcurrentHashMap

/** Describes a field of a recording by [text]. The schema in the file contains this text, for readers with other programs. */
@OptIn(ExperimentalSerializationApi::class)
@SerialInfo
@MustBeDocumented
@Target(AnnotationTarget.PROPERTY)
annotation class Holds(val text: String)

/** The schemas made so far. All agents share them. */
private val known = ConcurrentHashMap<SerialDescriptor, String>()

/** Returns the JSON schema of values with [descriptor]. Any thread may call this function. */
internal fun jsonSchema(descriptor: SerialDescriptor): String = known.computeIfAbsent(descriptor) { "${schemaOf(it)}" }

@OptIn(ExperimentalSerializationApi::class)
private fun schemaOf(descriptor: SerialDescriptor, meaning: String? = null): JsonObject = buildJsonObject {
    meaning?.let { put("description", it) }
    when (descriptor.kind) {
        StructureKind.LIST -> {
            put("type", "array")
            put("items", schemaOf(descriptor.getElementDescriptor(0)))
        }
        StructureKind.MAP -> {
            put("type", "object")
            put("additionalProperties", schemaOf(descriptor.getElementDescriptor(1)))
        }
        StructureKind.CLASS, StructureKind.OBJECT -> putFields(descriptor)
        PrimitiveKind.BOOLEAN -> put("type", "boolean")
        PrimitiveKind.LONG, PrimitiveKind.INT -> put("type", "integer")
        PrimitiveKind.STRING -> put("type", "string")
        else -> error("no field is ${descriptor.kind}")
    }
}

@OptIn(ExperimentalSerializationApi::class)
private fun JsonObjectBuilder.putFields(descriptor: SerialDescriptor) {
    val fields = 0 until descriptor.elementsCount
    put("type", "object")
    putJsonArray("required") {
        fields.filterNot(descriptor::isElementOptional).forEach { add(JsonPrimitive(descriptor.getElementName(it))) }
    }
    putJsonObject("properties") {
        for (field in fields) {
            val meaning = descriptor.getElementAnnotations(field).filterIsInstance<Holds>().firstOrNull()?.text
            put(descriptor.getElementName(field), schemaOf(descriptor.getElementDescriptor(field), meaning))
        }
    }
}
