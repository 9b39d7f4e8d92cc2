package argo.filters.format

import argo.filters.Problem
import java.io.StringReader
import javax.xml.stream.XMLInputFactory
import javax.xml.stream.XMLStreamConstants
import javax.xml.stream.XMLStreamException
import javax.xml.stream.XMLStreamReader

internal class XmlAttribute(val name: String, val value: String, val position: Position)

/** Text between two tags. [position] is that of the first character that is not white space. */
internal class XmlText(val text: String, val position: Position)

/** An element of the document. Names keep their prefixes. */
internal class XmlElement(val name: String, val position: Position, attributes: List<XmlAttribute>) {
    val attributes = ArrayList(attributes)
    val children = ArrayList<XmlElement>()
    val texts = ArrayList<XmlText>()

    var isClosed = false

    val text: String
        get() = texts.joinToString("", transform = XmlText::text).trim()

    /** The position of [text], or of the element if there is no text. */
    val textPosition: Position
        get() = texts.firstOrNull { it.text.isNotBlank() }?.position ?: position
}

/** Makes a factory for one document, because factories are not thread-safe. */
internal fun xmlInputFactory(): XMLInputFactory = XMLInputFactory.newDefaultFactory().apply {
    setProperty(XMLInputFactory.SUPPORT_DTD, false)
    setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false)
    setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, false)
    setProperty(XMLInputFactory.IS_COALESCING, true)
    xmlReporter = javax.xml.stream.XMLReporter { _, _, _, _ -> } // else the parser also prints the problems that it throws
}

/**
 * Reads an XML document into elements with their positions.
 *
 * The JDK's parser reports only the end of a tag. This class therefore searches for the tag's beginning in [document]. This class refuses
 * a document type declaration at once, so the parser never expands or fetches an entity.
 */
internal class XmlTree(private val document: String, private val source: String) {
    private val positions = SourceText(document)
    private val open = ArrayDeque<XmlElement>()

    /** The position after the last tag, comment or processing instruction. */
    private var markupEnd = 0

    /** The root element, as far as it could be read, or null. */
    var root: XmlElement? = null
        private set

    /** The problem that ended the reading early, or null. */
    val problem: Problem? = try {
        read(xmlInputFactory().createXMLStreamReader(StringReader(document)))
    } catch (e: XMLStreamException) {
        notWellFormed(e)
    }

    private fun read(reader: XMLStreamReader): Problem? {
        while (reader.hasNext()) event(reader)?.let { return it }
        return null
    }

    private fun event(reader: XMLStreamReader): Problem? {
        val event = reader.next()
        if (event == XMLStreamConstants.CHARACTERS || event == XMLStreamConstants.CDATA) text(reader.text) else markupEnd = endOf(reader)
        when (event) {
            XMLStreamConstants.START_ELEMENT -> start(reader)
            XMLStreamConstants.END_ELEMENT -> end()
            XMLStreamConstants.DTD -> return doctype()
        }
        return null
    }

    /** Returns the end of the tag. After a bare carriage return, the parser counts one character too few. */
    private fun endOf(reader: XMLStreamReader): Int {
        if (reader.location.lineNumber < 1) return document.length
        return document.indexOf('>', positions.offset(reader.location.lineNumber, reader.location.columnNumber) - 1) + 1
    }

    private fun start(reader: XMLStreamReader) {
        val start = document.lastIndexOf('<', markupEnd - 1) // attributes cannot contain <
        val tag = document.substring(start, markupEnd)
        val offsets = ATTRIBUTE.findAll(tag).associate { it.groupValues[1] to start + it.groups[1]!!.range.first }
        val attributes = (0 until reader.attributeCount).map {
            val name = nameOf(reader.getAttributePrefix(it), reader.getAttributeLocalName(it))
            XmlAttribute(name, reader.getAttributeValue(it), positions.position(offsets[name] ?: start))
        }
        val element = XmlElement(nameOf(reader.prefix, reader.localName), positions.position(start), attributes)
        if (open.isEmpty()) root = element else open.last().children += element
        open += element
    }

    private fun end() {
        val element = open.removeLast()
        element.isClosed = true
        if (element.name !in ATTRIBUTE_ELEMENTS || element.children.isNotEmpty() || open.isEmpty()) return
        open.last().children -= element
        open.last().attributes += XmlAttribute(element.name, element.text, element.textPosition)
    }

    private fun nameOf(prefix: String?, localName: String) = if (prefix.isNullOrEmpty()) localName else "$prefix:$localName"

    private fun text(found: String) {
        if (open.isEmpty()) return
        var offset = markupEnd
        if (found.isNotBlank()) while (document[offset].isWhitespace()) offset++
        open.last().texts += XmlText(found, positions.position(offset))
    }

    private fun doctype() = problem(
        positions.position(document.lastIndexOf("<!DOCTYPE", markupEnd)),
        "a document type declaration; filters have none, and no entities of their own",
    )

    private fun notWellFormed(e: XMLStreamException): Problem {
        val at = e.location?.takeIf { it.lineNumber > 0 }?.let { Position(it.lineNumber, it.columnNumber) } ?: positions.end
        return problem(at, "the text is not well-formed XML: ${words(e.message.orEmpty().substringAfter("Message: "))}")
    }

    private fun words(found: String) = when {
        document.isBlank() -> "it is empty"
        "[xX][mM][lL]" in found -> "<?xml …?> stands only at the very beginning; remove what is in front of it"
        else -> found
    }

    private fun problem(at: Position, message: String) = Problem(source, at.line, at.column, message)

    private companion object {
        val ATTRIBUTE = Regex("""\s([^\s=]+)\s*=\s*(?:"[^"]*"|'[^']*')""")

        /** In files of 2014, these attributes are elements. */
        val ATTRIBUTE_ELEMENTS = setOf("id", "name", "operator")
    }
}
