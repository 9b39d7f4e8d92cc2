package argo.filters.format

import argo.filters.FilterException
import argo.filters.PerceptionFilter
import java.io.InputStream

/** Filters in JSON files. */
object JsonFilters {
    internal const val EXTENSION = ".json"

    /**
     * Reads a filter.
     *
     * @param input the JSON document in UTF-8, with or without a byte-order mark. [read] does not close it.
     * @param source the file or other source of the document, for messages
     * @param name the filter's name, by default the last part of [source] without `.json`
     * @throws FilterException with all problems of the text
     * @throws java.io.IOException if [input] cannot be read
     */
    fun read(input: InputStream, source: String, name: String = nameOf(source, EXTENSION)): PerceptionFilter =
        read(decodeStrictly(input.readBytes(), Charsets.UTF_8, source), source, name)

    /** Reads a filter from decoded text. The other [read] describes the parameters and errors. */
    fun read(input: String, source: String, name: String = nameOf(source, EXTENSION)): PerceptionFilter =
        readFilter(source, name) { JsonTreeReader(input.removePrefix("\uFEFF"), source).read() }

    /** Returns the filter as a JSON document with LF line ends. [read] turns this document into an equal filter. */
    fun write(filter: PerceptionFilter): String = JsonFilterWriter().write(filter)
}
