package argo.filters.format

import argo.filters.PerceptionFilter
import java.io.InputStream

/** The kinds of files that filters are in, in the order in which they are looked for. */
internal enum class FilterFormat(
    val extension: String,
    private val mark: String,
    val read: (input: InputStream, source: String, name: String) -> PerceptionFilter,
) {
    XML(XmlFilters.EXTENSION, "<PerceptionFilter", XmlFilters::read),
    JSON(JsonFilters.EXTENSION, "\"rules\"", JsonFilters::read);

    /** Whether a file with this text could be a filter. */
    fun isLikely(text: String): Boolean = mark in text

    companion object {
        /** The format of a file of this name, or null if it is none of a filter. */
        fun of(fileName: String): FilterFormat? = entries.find { fileName.endsWith(it.extension) }

        /** A filter's name without the extension of a format. */
        fun bareName(name: String): String = of(name)?.let { name.removeSuffix(it.extension) } ?: name

        /** The files that a filter called [name] may be in. */
        fun candidates(name: String): List<Pair<String, FilterFormat>> =
            of(name)?.let { listOf(name to it) } ?: entries.map { name + it.extension to it }
    }
}
