package argo.recording

/** Returns this cycle in the form for a file, which states nothing twice. [whole] reverses the change. */
internal fun Cycle.compact(): Cycle = copy(
    input = input.copy(percepts = input.percepts?.compact(input.snapshots)),
    course = course.copy(step = course.step?.let { if (it.plan == course.plan) it.copy(plan = Place()) else it }),
)

/** Returns this cycle as it was before [compact]. */
internal fun Cycle.whole(): Cycle = copy(
    input = input.copy(percepts = input.percepts?.whole(input.snapshots)),
    course = course.copy(step = course.step?.let { if (it.plan == Place()) it.copy(plan = course.plan ?: Place()) else it }),
)

private fun PerceptChange.compact(snapshots: List<PerceivedSnapshot>): PerceptChange {
    val texts = snapshots.texts()
    val first = now.indices.firstOrNull { now[it] in texts } ?: return this
    val skip = texts.indexOf(now[first]) - first
    val others = now.indices.filter { now[it] != texts.getOrNull(skip + it) }.associateWith(now::get)
    return if (skip < 0 || others.size > now.size / 2) this else copy(now = emptyList(), skip = skip, take = now.size, others = others)
}

private fun PerceptChange.whole(snapshots: List<PerceivedSnapshot>): PerceptChange {
    if (take == 0) return this
    val texts = snapshots.texts()
    require(take <= texts.size + others.size) { "a cycle refers to $take percepts of ${texts.size}" }
    return PerceptChange(keep, List(take) { others[it] ?: texts[skip + it] }, keepLast)
}

/** Returns the percepts of these snapshots that the filters kept, in the notation of beliefs, which has no blanks. */
private fun List<PerceivedSnapshot>.texts(): List<String> =
    flatMap { it.kept ?: it.texts }.map { if ('"' in it) it else it.filterNot(Char::isWhitespace) }
