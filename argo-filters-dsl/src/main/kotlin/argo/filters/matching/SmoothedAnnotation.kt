package argo.filters.matching

private const val SMOOTHED = "smoothed"

/** Returns the text [percept] with `smoothed` as its last annotation. */
internal fun withSmoothed(percept: String): String {
    val text = percept.trimEnd()
    if (!text.endsWith(']')) return "$text[$SMOOTHED]"
    val others = text.dropLast(1).trimEnd()
    return when {
        hasSmoothed(others) -> percept
        others.endsWith('[') -> "$others$SMOOTHED]"
        else -> "$others,$SMOOTHED]"
    }
}

/** Returns the text [percept] without a final annotation `smoothed`, which a smoothing rule has added. */
fun withoutSmoothed(percept: String): String {
    val others = percept.removeSuffix("]")
    if (others.length == percept.length || !hasSmoothed(others)) return percept
    val before = others.removeSuffix(SMOOTHED)
    return if (before.endsWith('[')) before.dropLast(1) else "${before.dropLast(1)}]"
}

private fun hasSmoothed(others: String) = others.endsWith("[$SMOOTHED") || others.endsWith(",$SMOOTHED")
