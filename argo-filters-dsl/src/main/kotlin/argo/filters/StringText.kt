package argo.filters

internal object StringText {
    private const val UNICODE_DIGITS = 4

    private const val UNICODE_LENGTH = 2 + UNICODE_DIGITS

    /** Returns [text] in quotes and in Jason's syntax. Writes `\uXXXX` for characters that this syntax cannot express. */
    fun write(text: String): String {
        val written = quoted(text)
        val end = written.length
        val isJasons = Syntax.stringEnd(written, 0, end) == end && read(written.substring(1, end - 1)) == text
        return if (isJasons) written else quoted(text.replace("\\", "\\u005C").replace("\r", "\\u000D"))
    }

    private fun quoted(text: String) = "\"" + text.replace("\n", "\\n").replace("\"", "\\\"") + "\""

    /** Returns the string that [written] stands for. [written] is the text between the quotes. */
    fun read(written: String): String {
        if ("\\u" !in written) return asJason(written)
        val text = StringBuilder()
        var start = 0
        var i = 0
        while (i < written.length) {
            val isUnicode = written[i] == '\\' && isUnicode(written, i, written.length)
            if (isUnicode) {
                text.append(asJason(written.substring(start, i)))
                text.append(written.substring(i + 2, i + UNICODE_LENGTH).toInt(16).toChar())
                start = i + UNICODE_LENGTH
            }
            i += if (isUnicode) UNICODE_LENGTH else if (written[i] == '\\') 2 else 1
        }
        return text.append(asJason(written.substring(start))).toString()
    }

    /** Resolves escapes in Jason's way: first `\n`, then `\"`, and no others. */
    private fun asJason(written: String) = written.replace("\\n", "\n").replace("\\\"", "\"")

    fun isUnicode(text: CharSequence, start: Int, end: Int): Boolean =
        start + UNICODE_LENGTH <= end && text[start + 1] == 'u' && (2 until UNICODE_LENGTH).all { isHex(text[start + it]) }

    private fun isHex(c: Char) = c in '0'..'9' || c in 'a'..'f' || c in 'A'..'F'
}
