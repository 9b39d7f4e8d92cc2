package argo.lsp.filters

import com.google.gson.JsonObject
import com.google.gson.JsonParser

internal object JsonFilterSchema {
    private val schema: JsonObject =
        checkNotNull(javaClass.getResourceAsStream("/argo/filters/format/filter.schema.json")) { "there is no filter.schema.json" }
            .use { JsonParser.parseReader(it.reader()).asJsonObject }

    /** Returns the members that the object at [path] may have. */
    fun members(path: List<String>): List<Named> =
        at(path)?.getAsJsonObject("properties")?.entrySet().orEmpty().map { (name, kind) -> named(name, kind.asJsonObject) }

    /** Returns the member at [path]; null if there is none. */
    fun member(path: List<String>): Named? {
        val name = path.lastOrNull()?.takeIf { it != JsonPlace.ITEM } ?: return null
        return at(path.dropLast(1))?.getAsJsonObject("properties")?.getAsJsonObject(name)?.let { named(name, it) }
    }

    /** Returns the values, as JSON, that are possible at [path]; empty if there are too many to list. */
    fun values(path: List<String>): List<String> {
        val kind = at(path) ?: return emptyList()
        val listed = kind.getAsJsonArray("enum") ?: kind.getAsJsonArray("anyOf")?.first()?.asJsonObject?.getAsJsonArray("enum")
        if (kind["type"]?.toString() == "\"boolean\"") return listOf("true", "false")
        return listed?.map { "$it" }.orEmpty()
    }

    private fun at(path: List<String>): JsonObject? = path.fold(schema as JsonObject?) { kind, step ->
        val next = if (step == JsonPlace.ITEM) kind?.get("items") else kind?.getAsJsonObject("properties")?.get(step)
        next?.asJsonObject?.let(::resolved)
    }

    private fun named(name: String, kind: JsonObject) = Named(name, resolved(kind)["description"]?.asString.orEmpty())

    private fun resolved(kind: JsonObject): JsonObject {
        val name = kind["\$ref"]?.asString?.substringAfterLast('/') ?: return kind
        return schema.getAsJsonObject("definitions").getAsJsonObject(name)
    }
}
