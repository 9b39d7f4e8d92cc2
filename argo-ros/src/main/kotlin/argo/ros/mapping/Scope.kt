package argo.ros.mapping

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject

internal fun interface Scope {
    fun valueOf(path: Path): Value
}

/**
 * The fields of a message, and the constants of its type.
 *
 * @param bytes the paths of the byte arrays, which bridges encode as base64 text
 * @param constants the known constants
 */
internal class MessageScope(
    private val message: JsonElement,
    private val bytes: Set<Path> = emptySet(),
    private val constants: Map<String, JsonElement> = emptyMap(),
) : Scope {
    override fun valueOf(path: Path): Value {
        constantIn(path)?.takeIf { (message as? JsonObject)?.containsKey(it) != true }?.let { return constant(it) }
        val found = part(message, path, 0) as? Value.Part ?: return part(message, path, 0)
        return when (val value = Value.of(found.json)) {
            is Value.None -> Value.None("${written(path)}: ${value.why}")
            else -> value
        }
    }

    private fun constant(name: String): Value = constants[name]?.let(Value::of)
        ?: Value.None("there is no field $name, and no constant $name is known; rosapi describes constants")

    /** Follows [path] from step [index] on, starting at the part [at]. */
    private fun part(at: JsonElement, path: Path, index: Int): Value {
        val step = path.getOrNull(index) ?: return Value.Part(at)
        val inner = when (step) {
            is Step.Name -> (at as? JsonObject)?.get(step.name)
            is Step.Item -> (at as? JsonArray)?.let { it.getOrNull(step.indexIn(it.size)) }
            is Step.Sector -> return sector(at, step, path, index)
        } ?: return Value.None(missing(at, path.take(index), step))
        val known = if (bytes.isEmpty() || path.subList(0, index + 1) !in bytes) inner else bytesOf(inner) ?: return TOO_MANY_BYTES
        return part(known, path, index + 1)
    }

    private fun sector(at: JsonElement, step: Step.Sector, path: Path, index: Int): Value {
        val indices = (at as? JsonArray)?.let { step.indicesIn(it.size) } ?: return Value.None(missing(at, path.take(index), step))
        val items = indices.map { place -> part(at[place], path, index + 1) }
        return items.find { it is Value.None } ?: Value.Part(JsonArray(items.map { (it as Value.Part).json }))
    }

    private fun missing(at: JsonElement, path: Path, step: Step): String {
        val place = if (path.isEmpty()) "the message" else written(path)
        return when {
            at is JsonObject && step is Step.Name -> "$place has no field ${step.name}; it has ${at.keys.joinToString(", ")}"
            at is JsonArray && step !is Step.Name -> "the list $place has ${at.size} items, and no $step"
            at is JsonArray -> "$place is a list; take an item of it, as $place[0]$step"
            at is JsonNull -> "$place is null, so that it has no $step"
            step is Step.Name -> "$place is no message, so that it has no field ${step.name}"
            else -> "$place is no list, so that it has no $step"
        }
    }

    private companion object {
        val TOO_MANY_BYTES = Value.None("its bytes are no list: they are more than $MAX_ITEMS, or not in base64")
    }
}

private val CONSTANT = Regex("[A-Z][A-Z0-9_]+")

/** Returns the name if [path] is one name in capital letters, as constants are; otherwise null. */
internal fun constantIn(path: Path): String? = (path.singleOrNull() as? Step.Name)?.name?.takeIf(CONSTANT::matches)
