package argo.filters.matching

/**
 * ARGO's own beliefs about boards. The key is the functor with the number of arguments. The value lists the possible atoms of the last
 * argument; an empty set allows any term. A board cannot send ARGO's own beliefs as percepts. Filters do not drop ARGO's own beliefs.
 */
val OWN_BELIEFS: Map<String, Set<String>> =
    mapOf("port/2" to setOf("on", "off", "timeout"), "stale/1" to emptySet(), "reflex/2" to setOf("done", "failed"))

/**
 * Returns why a board cannot send this percept. Returns null if the percept is none of ARGO's own beliefs.
 *
 * @param indicator the percept's functor with its number of arguments, such as `port/2`
 * @param lastWord the functor of the percept's last argument; null: the argument has no functor
 */
fun whyClaimed(indicator: String, lastWord: String?): String? {
    val words = OWN_BELIEFS[indicator]?.takeIf { it.isEmpty() || lastWord in it } ?: return null
    val form = if (words.isEmpty()) indicator else "$indicator with ${words.joinToString(" or ")}"
    return "$form is a belief of ARGO's own, which no board can claim"
}
