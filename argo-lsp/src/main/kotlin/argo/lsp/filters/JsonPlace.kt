package argo.lsp.filters

/**
 * A place in a JSON document. The document may be incomplete at the place.
 *
 * @property path the members around the place, the outermost first; `[]` for an item of an array
 * @property isName true if the place is for the name of a member, false if it is for a value
 * @property isQuoted true if the place is between quotes
 * @property begin the offset at which the word at the place begins, after a quote
 */
internal data class JsonPlace(val path: List<String>, val isName: Boolean, val isQuoted: Boolean, val begin: Int) {
    companion object {
        /** A step of [path] into an item of an array. */
        const val ITEM = "[]"

        fun at(document: String, offset: Int): JsonPlace = JsonScan(document, offset).place()
    }
}

private class JsonScan(private val document: String, private val end: Int) {
    /** An open object or array. [name] is the member with the value that is being read or will be read next. */
    private class Level(val isObject: Boolean) {
        var name: String? = null
        var isInValue = false
    }

    private val levels = ArrayList<Level>()
    private var at = 0
    private var wordBegin = 0

    fun place(): JsonPlace {
        while (at < end) {
            val character = document[at]
            if (character == '"') {
                string()?.let { return it }
                continue
            }
            at++
            structure(character)
            if (!character.isLetterOrDigit() && character !in "-.+") wordBegin = at
        }
        return found(isQuoted = false, wordBegin)
    }

    private fun structure(character: Char) {
        when (character) {
            '{' -> levels += Level(isObject = true)
            '[' -> levels += Level(isObject = false)
            '}', ']' -> levels.removeLastOrNull()
            ':' -> levels.lastOrNull()?.isInValue = true
            ',' -> levels.lastOrNull()?.isInValue = false
        }
    }

    private fun string(): JsonPlace? {
        val begin = at + 1
        at = begin
        while (at < end && document[at] != '"' && document[at] != '\n') at += if (document[at] == '\\') 2 else 1
        if (at >= end) return found(isQuoted = true, begin)
        levels.lastOrNull()?.let { if (it.isObject && !it.isInValue) it.name = document.substring(begin, at) }
        at++
        wordBegin = at
        return null
    }

    private fun found(isQuoted: Boolean, begin: Int): JsonPlace {
        val isName = levels.lastOrNull()?.let { it.isObject && !it.isInValue } ?: false
        val path = levels.mapIndexedNotNull { depth, level ->
            when {
                !level.isObject -> JsonPlace.ITEM
                depth == levels.lastIndex && isName -> null
                else -> level.name.orEmpty()
            }
        }
        return JsonPlace(path, isName, isQuoted, begin)
    }
}
