package argo.lsp.filters

import org.w3c.dom.Element
import org.w3c.dom.Node
import javax.xml.parsers.DocumentBuilderFactory

internal class XmlElementKind(val named: Named, val attributes: List<Named>, elements: () -> List<XmlElementKind>) {
    val elements: List<XmlElementKind> by lazy(elements)
}

internal object XmlFilterSchema {
    private val schema: Element = checkNotNull(javaClass.getResourceAsStream("/argo/filters/format/filter.xsd")) { "filter.xsd is missing" }
        .use { DocumentBuilderFactory.newDefaultInstance().newDocumentBuilder().parse(it).documentElement }
    private val root = schema.children("element").map(::element)

    /** Returns the elements that the innermost element of [open] may contain; empty if [open] is no valid nesting. */
    fun elementsIn(open: List<String>): List<XmlElementKind> =
        open.fold(root) { known, name -> known.find { it.named.name == name }?.elements.orEmpty() }

    /** Returns the element [name] if the innermost element of [open] may contain it, else null. */
    fun element(open: List<String>, name: String): XmlElementKind? = elementsIn(open).find { it.named.name == name }

    private fun element(node: Element): XmlElementKind {
        val type = node.children("complexType").firstOrNull() ?: global("complexType", node.getAttribute("type"))
        return XmlElementKind(named(node), type?.let(::attributes).orEmpty()) { type?.let(::elements).orEmpty() }
    }

    private fun elements(node: Element): List<XmlElementKind> = node.children().flatMap { child ->
        when (child.localPart) {
            "element" -> listOf(element(child))
            "group" -> elements(global("group", child.getAttribute("ref")) ?: child)
            "attribute" -> emptyList()
            else -> elements(child)
        }
    }.distinctBy { it.named.name }

    private fun attributes(node: Element): List<Named> = node.children().flatMap { child ->
        when (child.localPart) {
            "attribute" -> listOf(named(child, values(child.getAttribute("type"))))
            "attributeGroup" -> attributes(global("attributeGroup", child.getAttribute("ref")) ?: child)
            "simpleContent", "extension" -> attributes(child)
            else -> emptyList()
        }
    }

    /**
     * Returns the values of a simple type. For a union, returns the values of the first part, since the other parts are only other
     * spellings.
     */
    private fun values(type: String): List<String> {
        val simple = global("simpleType", type) ?: return emptyList()
        val union = simple.children("union").firstOrNull()
        if (union != null) return values(union.getAttribute("memberTypes").substringBefore(' '))
        return simple.children("restriction").flatMap { it.children("enumeration") }.map { it.getAttribute("value") }
    }

    private fun named(node: Element, values: List<String> = emptyList()) = Named(
        node.getAttribute("name"),
        node.children("annotation").flatMap { it.children("documentation") }.joinToString("\n\n") { it.textContent.trim() }, values,
    )

    private fun global(kind: String, name: String): Element? = schema.children(kind).find { it.getAttribute("name") == name }

    private val Element.localPart get() = tagName.substringAfter(':')

    private fun Element.children(kind: String? = null): List<Element> = (0 until childNodes.length).map(childNodes::item)
        .filter { it.nodeType == Node.ELEMENT_NODE }.map { it as Element }.filter { kind == null || it.localPart == kind }
}
