package argo.tools.command

/**
 * Returns the name in [names] that [word] is probably a slip of; null: there is none. A slip differs by a letter or two, or only by case.
 */
internal fun closest(word: String, names: Collection<String>): String? =
    names.minByOrNull { distance(word, it) }?.takeIf { distance(word, it) <= if (word.length > LONG) 2 else 1 }

/** Returns how many letters must be added, removed or replaced to turn [a] into [b], without regard to case. */
private fun distance(a: String, b: String): Int {
    var row = IntArray(b.length + 1) { it }
    for (i in a.indices) {
        val next = IntArray(b.length + 1)
        next[0] = i + 1
        for (j in b.indices) {
            val replaced = row[j] + if (a[i].equals(b[j], ignoreCase = true)) 0 else 1
            next[j + 1] = minOf(replaced, row[j + 1] + 1, next[j] + 1)
        }
        row = next
    }
    return row[b.length]
}

private const val LONG = 4
