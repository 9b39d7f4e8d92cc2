package argo.check.rules

/** Names that a person may have meant. */
internal object Names {
    /**
     * Returns the name in [names] that [written] probably means, other than [written]: one letter is missing, added or another, or two
     * neighbours are swapped; in long names also two of these. `pos1` is no slip of `pos2`, nor `OldX` of `OldY`.
     */
    fun near(written: String, names: Collection<String>): String? =
        names.filter { it != written && it.length > MIN_LENGTH && isNear(written, it) }
            .minWithOrNull(compareBy({ distance(written, it) }, { it }))

    private fun isNear(a: String, b: String): Boolean {
        val shorter = minOf(a.length, b.length)
        if (shorter < MIN_LENGTH || kotlin.math.abs(a.length - b.length) > 1 || haveOtherLetters(a, b)) return false
        return distance(a, b) <= (if (shorter >= LONG && a[0] == b[0]) 2 else 1) && !areVariants(a, b)
    }

    /** Returns true if the letters show, without a closer look, that more than two slips are between the names. */
    private fun haveOtherLetters(a: String, b: String): Boolean {
        fun letters(name: String) = name.fold(0L) { set, letter -> set or (1L shl letter.code) }
        return (letters(a) xor letters(b)).countOneBits() > MOST_OTHER_LETTERS
    }

    /** Returns true if the names tell things of one kind apart: by a number, or by a part of one letter, as the X of `OldX`. */
    private fun areVariants(a: String, b: String): Boolean {
        if (a.filterNot(Char::isDigit) == b.filterNot(Char::isDigit)) return true
        val at = a.indices.filter { it < b.length && a[it] != b[it] }.singleOrNull() ?: return false
        return a.length == b.length && isPart(a, at) && isPart(b, at)
    }

    private fun isPart(name: String, at: Int): Boolean {
        fun isEnd(index: Int) = name.getOrNull(index)?.let { it == '_' || it == '.' || it.isDigit() || it.isUpperCase() } ?: true
        return name[at].isUpperCase() && !(name.getOrNull(at + 1)?.isLowerCase() == true && at > 0) || isEnd(at - 1) && isEnd(at + 1)
    }

    /** Returns how many letters must be added, removed, replaced or swapped with their neighbours to make [b] of [a]. */
    private fun distance(a: String, b: String): Int {
        var before = IntArray(0)
        var row = IntArray(b.length + 1) { it }
        for (i in a.indices) {
            val next = IntArray(b.length + 1)
            next[0] = i + 1
            for (j in b.indices) {
                next[j + 1] = minOf(row[j] + if (a[i] == b[j]) 0 else 1, row[j + 1] + 1, next[j] + 1)
                if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j]) next[j + 1] = minOf(next[j + 1], before[j - 1] + 1)
            }
            before = row
            row = next
        }
        return row[b.length]
    }

    /** Two letters that are replaced by two others. */
    private const val MOST_OTHER_LETTERS = 4
    private const val MIN_LENGTH = 2
    private const val LONG = 10
}
