package argo.filters.format

import argo.filters.Problem
import java.io.StringReader
import javax.xml.stream.XMLInputFactory
import javax.xml.stream.XMLStreamConstants
import javax.xml.stream.XMLStreamException
import javax.xml.stream.XMLStreamReader

internal class XmlAttribute(val name: String, val value: String, val position: Position)

/** Text between two tags; [position] is that of its first character that is not white space. */
internal class XmlText(val text: String, val position: Position)

/** An element as it stands in the document; names are kept as written, prefix included. */
internal class XmlElement(val name: String, val position: Position, val attributes: List<XmlAttribute>) {
    val children = ArrayList<XmlElement>()
    val texts = ArrayList<XmlText>()

    /** Whether its end tag has been read. */
    var isClosed = false

    /** The text directly in the element, blanks around it aside. */
    val text: String
        get() = texts.joinToString("", transform = XmlText::text).trim()

    /** Where that text begins, or the element where there is none. */
    val textPosition: Position
        get() = texts.firstOrNull { it.text.isNotBlank() }?.position ?: position
}

/** What could be read of a document: its root, if there was one, and why reading ended early, if it did. */
internal class XmlTree(val root: XmlElement?, val problem: Problem?)

/**
 * Reads an XML document into elements that know where they stand.
 *
 * The JDK's parser does the reading, since it takes nothing but well-formed XML; others let duplicate attributes pass.
 * A document type declaration is refused before anything that it declares could be used, so no entity is ever expanded or fetched.
 */
internal class XmlTreeReader(private val text: SourceText, private val source: String) {
    private val markup = XmlMarkup(text.text)
    private val open = ArrayDeque<XmlElement>()
    private var root: XmlElement? = null

    /** Whether the element that was opened last is empty and the parser has yet to say so. */
    private var justOpened = false

    fun read(): XmlTree = try {
        val reader = factory().createXMLStreamReader(StringReader(text.text))
        var problem: Problem? = null
        while (problem == null && reader.hasNext()) problem = event(reader)
        XmlTree(root, problem)
    } catch (e: XMLStreamException) {
        XmlTree(root, notWellFormed(e))
    }

    private fun event(reader: XMLStreamReader): Problem? {
        when (reader.next()) {
            XMLStreamConstants.START_ELEMENT -> start(reader)
            XMLStreamConstants.END_ELEMENT -> end()
            XMLStreamConstants.COMMENT, XMLStreamConstants.PROCESSING_INSTRUCTION -> markup.step()
            XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> text(reader.text)
            XMLStreamConstants.DTD -> return doctype()
        }
        return null
    }

    private fun start(reader: XMLStreamReader) {
        markup.step()
        val element = XmlElement(nameOf(reader.prefix, reader.localName), text.position(markup.start), attributes(reader))
        if (open.isEmpty()) root = element else open.last().children += element
        open += element
        justOpened = markup.isEmptyElement
    }

    private fun end() {
        if (justOpened) justOpened = false else markup.step()
        open.removeLast().isClosed = true
    }

    private fun attributes(reader: XMLStreamReader): List<XmlAttribute> {
        if (reader.attributeCount == 0) return emptyList()
        val offsets = markup.attributeOffsets()
        return List(reader.attributeCount) {
            val name = nameOf(reader.getAttributePrefix(it), reader.getAttributeLocalName(it))
            XmlAttribute(name, reader.getAttributeValue(it), text.position(offsets[name] ?: markup.start))
        }
    }

    private fun nameOf(prefix: String?, localName: String) = if (prefix.isNullOrEmpty()) localName else "$prefix:$localName"

    private fun text(found: String) {
        if (open.isEmpty()) return
        var offset = markup.end
        if (found.isNotBlank()) while (text.text[offset].isWhitespace()) offset++
        open.last().texts += XmlText(found, text.position(offset))
    }

    private fun doctype(): Problem {
        markup.step()
        return problem(text.position(markup.start), "a document type declaration; filters have none, and no entities of their own")
    }

    private fun notWellFormed(e: XMLStreamException): Problem {
        val at = e.location?.takeIf { it.lineNumber > 0 }?.let { Position(it.lineNumber, it.columnNumber) } ?: text.end
        val cause = e.message.orEmpty().substringAfter("Message: ")
        return problem(at, "the text is not well-formed XML: $cause")
    }

    private fun problem(at: Position, message: String) = Problem(source, at.line, at.column, message)

    private companion object {
        /** A new one for each document, since factories are not safe for several threads at once. */
        fun factory(): XMLInputFactory = XMLInputFactory.newDefaultFactory().apply {
            setProperty(XMLInputFactory.SUPPORT_DTD, false)
            setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false)
            setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, false)
            setProperty(XMLInputFactory.IS_COALESCING, true)
        }
    }
}
