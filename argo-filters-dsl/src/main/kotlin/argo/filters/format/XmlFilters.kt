package argo.filters.format

import argo.filters.FilterException
import argo.filters.PerceptionFilter
import argo.filters.Problem
import java.io.InputStream
import java.nio.charset.Charset
import javax.xml.stream.XMLStreamException

/** Filters in XML files. */
object XmlFilters {
    internal const val EXTENSION = ".xml"

    /**
     * Reads a filter.
     *
     * @param input the XML document. The document's XML declaration or byte-order mark (UTF-8 or UTF-16) determines the encoding. The
     *     default is UTF-8. [read] does not close it.
     * @param source the file or other source of the document, for messages
     * @param name the filter's name, by default the last part of [source] without `.xml`
     * @throws FilterException with all problems of the text
     * @throws java.io.IOException if [input] cannot be read
     */
    fun read(input: InputStream, source: String, name: String = nameOf(source, EXTENSION)): PerceptionFilter {
        val bytes = input.readBytes()
        return read(decodeStrictly(bytes, encodingOf(bytes, source), source), source, name)
    }

    /** Reads a filter from decoded text. The other [read] describes the parameters and errors. */
    fun read(input: String, source: String, name: String = nameOf(source, EXTENSION)): PerceptionFilter =
        readFilter(source, name) { XmlFilterTree(XmlTree(input.removePrefix("\uFEFF"), source), it).filter() }

    /**
     * Returns the filter as an XML document with LF line ends. [read] turns this document into an equal filter.
     *
     * @throws IllegalArgumentException if a functor or a string of the filter contains a character that XML cannot express
     */
    fun write(filter: PerceptionFilter): String = XmlFilterWriter().write(filter)

    /** Returns a document's encoding, found in its first bytes. [read] reports bytes that are not in this encoding. */
    private fun encodingOf(bytes: ByteArray, source: String): Charset {
        if (!mayDeclare(bytes)) return Charsets.UTF_8
        val tagEnd = bytes.indexOf('>'.code.toByte()) + 1
        val isWide = tagEnd < bytes.size && bytes[tagEnd] == 0.toByte()
        val beginning = bytes.copyOf(if (isWide) tagEnd + 1 else tagEnd)
        return try {
            Charset.forName(xmlInputFactory().createXMLStreamReader(beginning.inputStream()).encoding ?: "UTF-8")
        } catch (e: XMLStreamException) {
            if (!String(beginning, Charsets.ISO_8859_1).startsWith("<?xml")) return Charsets.UTF_8
            val cause = e.message.orEmpty().substringAfter("Message: ")
            val message = "the XML declaration cannot be read; UTF-8 is a good choice of encoding: $cause"
            throw FilterException(listOf(Problem(source, 1, 1, message)), e)
        }
    }

    /** Whether the parser may find an encoding in [bytes]. For other bytes it would print a message of its own. */
    private fun mayDeclare(bytes: ByteArray): Boolean {
        val beginning = String(bytes.copyOf(minOf(bytes.size, BEGINNING)), Charsets.ISO_8859_1)
        return WIDE.any { beginning.startsWith(it) } || beginning.removePrefix("\u00EF\u00BB\u00BF").startsWith("<?xml")
    }

    /** As many bytes as a byte-order mark of UTF-8 and `<?xml`. */
    private const val BEGINNING = 8

    /** How a document in UTF-16 begins: with a byte-order mark or `<`. */
    private val WIDE = listOf("\u00FE\u00FF", "\u00FF\u00FE", "\u0000<", "<\u0000")
}

internal fun nameOf(source: String, extension: String): String =
    source.substringAfterLast('/').substringAfterLast('\\').removeSuffix(extension)
