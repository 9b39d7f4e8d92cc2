package argo.filters.matching

/**
 * ARGO's own beliefs about boards, by functor and number of arguments, with the atoms that the last argument can be; no atoms: any term. A
 * board cannot send these beliefs as percepts, and filters do not drop them.
 */
val OWN_BELIEFS: Map<String, Set<String>> =
    mapOf("port/2" to setOf("on", "off", "timeout"), "stale/1" to emptySet(), "reflex/2" to setOf("done", "failed"))

/**
 * Returns the reason why a board cannot send this percept; null: the percept is none of ARGO's own beliefs.
 *
 * @param indicator the percept's functor with its number of arguments, as `port/2`
 * @param lastWord the functor of the percept's last argument; null: the argument has no functor
 */
fun whyClaimed(indicator: String, lastWord: String?): String? {
    val words = OWN_BELIEFS[indicator]?.takeIf { it.isEmpty() || lastWord in it } ?: return null
    val form = if (words.isEmpty()) indicator else "$indicator with ${words.joinToString(" or ")}"
    return "$form is a belief of ARGO's own, which no board can claim"
}
