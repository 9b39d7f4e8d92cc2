package argo.lsp.filters

/**
 * A place in an XML document. The document may be incomplete at the place.
 *
 * @property open the names of the elements around the place, the root first. If the place is in a tag, the tag's element is left out
 * @property begin the offset at which the word at the place begins
 */
internal data class XmlPlace(val open: List<String>, val part: Part, val begin: Int) {
    /** The kind of text at a place. */
    sealed interface Part {
        /** Text between tags. */
        data object Content : Part

        /** The name of a tag. If [isEnd] is true, the name of an end tag. */
        data class Name(val isEnd: Boolean) : Part

        data class Attribute(val element: String) : Part

        data class Value(val element: String, val attribute: String) : Part

        /** A comment, a processing instruction, or a blank in a tag where no word is allowed. */
        data object Nothing : Part
    }

    companion object {
        fun at(document: String, offset: Int): XmlPlace = XmlScan(document, offset).place()
    }
}

private class XmlScan(private val document: String, private val end: Int) {
    private val open = ArrayList<String>()
    private var at = 0

    fun place(): XmlPlace {
        while (true) {
            val begin = at
            val tag = document.indexOf('<', at)
            if (tag < 0 || tag >= end) return XmlPlace(open, XmlPlace.Part.Content, begin)
            at = tag
            val found = if (!skipAside("<!--", "-->") && !skipAside("<?", "?>") && !skipAside("<![CDATA[", "]]>")) tag() else null
            if (found != null) return found
            if (at > end) return XmlPlace(open, XmlPlace.Part.Nothing, end)
        }
    }

    private fun skipAside(from: String, to: String): Boolean {
        if (!document.startsWith(from, at)) return false
        val close = document.indexOf(to, at + from.length)
        at = if (close < 0 || close + to.length > end) end + 1 else close + to.length
        return true
    }

    /** Reads a tag. Returns the place if it is in the tag, else null. */
    private fun tag(): XmlPlace? {
        at++
        val isEnd = document.getOrNull(at) == '/'
        if (isEnd) at++
        val name = word()
        if (at >= end) return XmlPlace(open, XmlPlace.Part.Name(isEnd), end.coerceAtMost(at - name.length))
        attributes(name)?.let { return it }
        val isEmpty = document[at - 1] == '/'
        if (document.getOrNull(at) == '>') at++
        if (isEnd) close(name) else if (!isEmpty) open += name
        return null
    }

    /** Closes the element [name] and the open elements in it. */
    private fun close(name: String) {
        val found = open.lastIndexOf(name)
        if (found >= 0) open.subList(found, open.size).clear()
    }

    private fun attributes(element: String): XmlPlace? {
        while (at < end && document[at] != '>' && document[at] != '<') {
            val blank = at
            val name = word()
            if (at >= end) return XmlPlace(open, XmlPlace.Part.Attribute(element), blank)
            when {
                document[at] == '"' || document[at] == '\'' -> value(element, attributeBefore())?.let { return it }
                at == blank -> at++
            }
            if (name.isEmpty() && at >= end) return XmlPlace(open, partBehind(element), end)
        }
        return null
    }

    private fun partBehind(element: String) =
        if (document[end - 1].isWhitespace()) XmlPlace.Part.Attribute(element) else XmlPlace.Part.Nothing

    private fun attributeBefore(): String {
        val head = document.substring(0, at).trimEnd().removeSuffix("=").trimEnd()
        return head.takeLastWhile(::isOfName)
    }

    private fun value(element: String, attribute: String): XmlPlace? {
        val close = document.indexOf(document[at], at + 1)
        if (close < 0 || close >= end) return XmlPlace(open, XmlPlace.Part.Value(element, attribute), at + 1)
        at = close + 1
        return null
    }

    private fun word(): String {
        val begin = at
        while (at < end && at < document.length && isOfName(document[at])) at++
        return document.substring(begin, at)
    }

    private fun isOfName(character: Char) = character.isLetterOrDigit() || character in "_-.:"
}
