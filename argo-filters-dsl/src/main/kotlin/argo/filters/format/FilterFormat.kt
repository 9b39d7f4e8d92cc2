package argo.filters.format

import argo.filters.PerceptionFilter
import java.io.InputStream

/** The kinds of filter files, in the order of the search. */
internal enum class FilterFormat(
    val extension: String,
    private val mark: String,
    val read: (input: InputStream, source: String, name: String) -> PerceptionFilter,
) {
    XML(XmlFilters.EXTENSION, "<PerceptionFilter", XmlFilters::read),
    JSON(JsonFilters.EXTENSION, "\"rules\"", JsonFilters::read);

    /** Returns true if a file with this text may be a filter. */
    fun isLikely(text: String): Boolean = mark in text

    companion object {
        /** Returns the format for a file name, or null if filter files have no such names. */
        fun of(fileName: String): FilterFormat? = entries.find { fileName.endsWith(it.extension) }

        fun bareName(name: String): String = of(name)?.let { name.removeSuffix(it.extension) } ?: name

        fun candidates(name: String): List<Pair<String, FilterFormat>> =
            of(name)?.let { listOf(name to it) } ?: entries.map { name + it.extension to it }
    }
}
