package argo.check.rules

/** Finds the one of [names] that a person may have meant. Make one instance for many questions, since it sorts the names. */
internal class SimilarNames(names: Collection<String>) {
    private val byLength: Map<Int, List<Name>> by lazy {
        names.toSet().filter { it.length > MIN_LENGTH }.map(::Name).groupBy { it.text.length }
    }

    /**
     * Returns the name that [written] probably means. One letter may be missing, extra or wrong, or two neighbouring letters may be
     * swapped. A long name may have two such errors. `pos1` and `pos2` count as different names, and so do `OldX` and `OldY`. Names with
     * different first letters, such as `winner` and `inner`, also count as different. An exception is a swap of the first two letters.
     */
    fun near(written: String): String? {
        val name = Name(written)
        return (written.length - 1..written.length + 1).asSequence().flatMap { byLength[it].orEmpty() }
            .filter { name.isLike(it) && isNear(written, it.text) }
            .map { it.text }.minWithOrNull(compareBy({ editDistance(written, it) }, { it }))
    }

    /** A name and its set of letters. The set quickly excludes most other names. */
    private class Name(val text: String) {
        private val letters = text.fold(0L) { set, letter -> set or (1L shl letter.code) }
        private val withoutDigits = text.filterNot(Char::isDigit)

        fun isLike(other: Name): Boolean =
            (letters xor other.letters).countOneBits() <= MOST_OTHER_LETTERS && withoutDigits != other.withoutDigits
    }

    companion object {
        fun near(written: String, names: Collection<String>): String? = SimilarNames(names).near(written)
    }
}

private fun isNear(a: String, b: String): Boolean {
    val shorter = minOf(a.length, b.length)
    if (shorter < MIN_LENGTH || !beginAlike(a, b)) return false
    return editDistance(a, b) <= (if (shorter >= LONG && a[0] == b[0]) MOST_SLIPS else 1) && !areVariants(a, b)
}

/** Returns true if the first letters are equal or the first two letters are swapped. Ignores the dot of an internal action. */
private fun beginAlike(a: String, b: String): Boolean {
    val (one, other) = a.trimStart('.') to b.trimStart('.')
    return one.firstOrNull() == other.firstOrNull() || one.take(2) == other.take(2).reversed()
}

/**
 * Returns true if the names differ only in a one-letter word, like `OldX` and `OldY`. `OldX` and `OldY` belong to two things of one kind.
 */
private fun areVariants(a: String, b: String): Boolean {
    val at = a.indices.filter { it < b.length && a[it] != b[it] }.singleOrNull() ?: return false
    return a.length == b.length && isPart(a, at) && isPart(b, at)
}

private fun isPart(name: String, at: Int): Boolean {
    fun isEnd(index: Int) = name.getOrNull(index)?.let { it == '_' || it == '.' || it.isDigit() || it.isUpperCase() } ?: true
    return name[at].isUpperCase() && !(name.getOrNull(at + 1)?.isLowerCase() == true && at > 0) || isEnd(at - 1) && isEnd(at + 1)
}

/**
 * Returns the number of letters to add, remove, replace or swap with a neighbour that turns [a] into [b]. A result above 2 only means that
 * the number is greater than 2.
 */
fun editDistance(a: String, b: String): Int {
    val start = a.commonPrefixWith(b).length
    val end = a.substring(start).commonSuffixWith(b.substring(start)).length
    return distanceWithin(a.substring(start, a.length - end), b.substring(start, b.length - end))
}

private fun distanceWithin(a: String, b: String): Int {
    var before = IntArray(0)
    var row = IntArray(b.length + 1) { it }
    for (i in a.indices) {
        val next = IntArray(b.length + 1)
        next[0] = i + 1
        for (j in b.indices) {
            next[j + 1] = minOf(row[j] + if (a[i] == b[j]) 0 else 1, row[j + 1] + 1, next[j] + 1)
            if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j]) next[j + 1] = minOf(next[j + 1], before[j - 1] + 1)
        }
        if (next.min() > MOST_SLIPS && row.min() >= MOST_SLIPS) return MOST_SLIPS + 1 // swapping letters adds 1 to a value of `before`
        before = row
        row = next
    }
    return row[b.length]
}

/** Two replaced letters change at most this many elements of the letter sets. */
private const val MOST_OTHER_LETTERS = 4
private const val MIN_LENGTH = 2
private const val LONG = 10
private const val MOST_SLIPS = 2
