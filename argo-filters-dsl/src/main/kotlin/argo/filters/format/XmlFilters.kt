package argo.filters.format

import argo.filters.FilterException
import argo.filters.PerceptionFilter
import java.io.InputStream

/** Filters in XML files. */
object XmlFilters {
    internal const val EXTENSION = ".xml"

    /**
     * Reads a filter.
     *
     * @param input the XML document, in any encoding that its declaration or byte-order mark names; UTF-8 where there is neither. Not closed.
     * @param source the file or other place it comes from, for messages
     * @param name the filter's name; usually the last part of [source] without `.xml`
     * @throws FilterException with all problems of the text, if there are any
     * @throws java.io.IOException if [input] cannot be read
     */
    fun read(input: InputStream, source: String, name: String = nameOf(source, EXTENSION)): PerceptionFilter =
        read(XmlDecoder(source).decode(input.readBytes()), source, name)

    /** As the other form, from text that has been decoded. */
    fun read(input: String, source: String, name: String = nameOf(source, EXTENSION)): PerceptionFilter =
        XmlFilterReader(input.removePrefix("\uFEFF"), source, name).read()

    /**
     * The filter as an XML document with LF line ends, which [read] reads back to an equal filter.
     *
     * @throws IllegalArgumentException if a functor or a string of the filter holds a character that XML has no way to write
     */
    fun write(filter: PerceptionFilter): String = XmlFilterWriter().write(filter)
}

/** What a filter is called whose text comes from [source]. */
internal fun nameOf(source: String, extension: String): String =
    source.substringAfterLast('/').substringAfterLast('\\').removeSuffix(extension)
