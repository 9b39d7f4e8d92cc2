package argo.filters.format

/**
 * Steps through the markup of an XML text that a parser is reading at the same time: one step for each tag, comment, processing
 * instruction or document type declaration that the parser has accepted.
 *
 * The JDK's parser knows the line of what it reads, but its offsets drift in files longer than its buffer, and it has none for attributes.
 */
internal class XmlMarkup(private val text: String) {
    /** Where the markup of the last step begins. */
    var start = 0
        private set

    /** Where the markup of the last step ends, the character after it. */
    var end = 0
        private set

    init {
        if (DECLARATION.matchesAt(text, 0)) end = text.indexOf("?>") + 2
    }

    /** Whether the last step was a tag that opens and closes its element at once. */
    val isEmptyElement: Boolean
        get() = text.startsWith("/>", end - 2)

    fun step() {
        start = text.indexOf('<', end)
        while (text.startsWith(CDATA, start)) start = text.indexOf('<', text.indexOf("]]>", start))
        end = when {
            text.startsWith("<!--", start) -> text.indexOf("-->", start + 4) + 3
            text.startsWith("<?", start) -> text.indexOf("?>", start) + 2
            else -> tagEnd()
        }
    }

    /** Where each attribute of the start tag of the last step begins, by its name as written. */
    fun attributeOffsets(): Map<String, Int> {
        val offsets = HashMap<String, Int>()
        var match = TAG_NAME.matchAt(text, start + 1)?.let { ATTRIBUTE.matchAt(text, it.range.last + 1) }
        while (match != null) {
            offsets[match.groupValues[1]] = match.groups[1]!!.range.first
            match = ATTRIBUTE.matchAt(text, match.range.last + 1)
        }
        return offsets
    }

    private fun tagEnd(): Int {
        var quote: Char? = null
        for (i in start until text.length) {
            val c = text[i]
            when {
                quote != null -> if (c == quote) quote = null
                c == '"' || c == '\'' -> quote = c
                c == '>' -> return i + 1
            }
        }
        return text.length
    }

    private companion object {
        const val CDATA = "<![CDATA["
        val DECLARATION = Regex("""<\?xml\s""")
        val TAG_NAME = Regex("""[^\s/>]+""")
        val ATTRIBUTE = Regex("""\s+([^\s=]+)\s*=\s*(?:"[^"]*"|'[^']*')""")
    }
}
