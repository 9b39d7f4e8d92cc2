package argo.filters

import java.io.InputStream

/** Filters in XML files. */
object XmlFilters {
    /**
     * Reads a filter.
     *
     * @param input the XML document, in any encoding that its declaration or byte-order mark names; UTF-8 where there is neither. Not closed.
     * @param source the file or other place it comes from, for messages; its last part without `.xml` becomes the filter's name
     * @throws FilterException with all problems of the text, if there are any
     * @throws java.io.IOException if [input] cannot be read
     */
    fun read(input: InputStream, source: String): PerceptionFilter = TODO()

    /** As the other form, from text that has been decoded. */
    fun read(input: String, source: String): PerceptionFilter = TODO()

    /** The filter as an XML document, which [read] reads back to an equal filter. */
    fun write(filter: PerceptionFilter): String = TODO()
}
