package argo.filters

/** Moves over the parts of terms in [text], from [at] to [end]. A function returns null if its part is missing. */
internal abstract class TermCursor(protected val text: CharSequence, protected var at: Int, protected val end: Int) {

    /** Skips the blanks between the parts of a term. Returns the position of the next part. */
    protected abstract fun blanks(): Int

    protected fun isNext(expected: Char): Boolean = blanks() < end && text[at] == expected

    protected fun take(expected: Char): Boolean = isNext(expected).also { if (it) at++ }

    /** Reads one or more items with commas between them. Returns null if [item] finds none. */
    protected inline fun <T : Any> items(item: () -> T?): ArrayList<T>? {
        val items = ArrayList<T>(USUAL_ARITY)
        do items += item() ?: return null while (take(','))
        return items
    }

    protected fun double(): Double? {
        val start = at
        val numberEnd = Syntax.numberEnd(text, start, end)
        if (numberEnd < 0) return null
        at = numberEnd
        val plain = DecimalReader.plain(text, start, numberEnd)
        return if (plain.isNaN()) text.substring(start, numberEnd).toDouble() else plain
    }

    protected fun quoted(): String? {
        val start = at
        val stringEnd = Syntax.stringEnd(text, start, end)
        if (stringEnd < 0) return null
        at = stringEnd
        return StringText.read(text.substring(start + 1, stringEnd - 1))
    }

    companion object {
        const val USUAL_ARITY = 4
    }
}
