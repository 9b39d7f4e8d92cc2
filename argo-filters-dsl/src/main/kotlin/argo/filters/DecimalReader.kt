package argo.filters

/** Reads decimal numbers, in the form that boards write, in place. */
internal object DecimalReader {
    /** The most digits for which digits divided by a power of ten always give the nearest double. */
    private const val MAX_DIGITS = 15
    private val POWERS = DoubleArray(MAX_DIGITS + 1) { "1e$it".toDouble() }

    /**
     * Returns the number in the text from [start] to [end]: an optional sign, digits, an optional fraction. Blanks may follow. Returns
     * NaN for any other text, even for other forms of numbers. Allocates nothing.
     */
    fun plain(text: CharSequence, start: Int, end: Int): Double {
        val negative = text[start] == '-'
        val unsigned = if (negative || text[start] == '+') start + 1 else start
        var i = unsigned
        var digits = 0L
        var point = -1
        while (i < end) {
            val c = text[i]
            if (c in '0'..'9') digits = digits * 10 + (c - '0')
            else if (c == '.' && point < 0) point = i
            else break
            if (++i - unsigned > MAX_DIGITS) return Double.NaN
        }
        val decimals = if (point < 0) 0 else i - point - 1
        if (i == unsigned || point >= 0 && decimals == 0 || Syntax.skipBlanks(text, i, end) != end) return Double.NaN
        val value = digits / POWERS[decimals]
        return if (negative) -value else value
    }

    /**
     * Returns the place value of the last digit before the exponent, in the text from [start] to [end]. Returns 0 for text that is no
     * number.
     */
    fun unit(text: CharSequence, start: Int, end: Int): Double {
        var point = -1
        for (i in start until end) {
            val c = text[i]
            if (c == '.') point = i
            else if (c == 'e' || c == 'E') return unit(point, i) * ("1${text.subSequence(i, end)}".toDoubleOrNull() ?: 0.0)
            else if (c !in '0'..'9' && i > start) return if (Syntax.skipBlanks(text, i, end) == end) unit(point, i) else 0.0
        }
        return unit(point, end)
    }

    private fun unit(point: Int, end: Int): Double = if (point < 0) 1.0 else 1 / POWERS[minOf(end - point - 1, MAX_DIGITS)]
}
