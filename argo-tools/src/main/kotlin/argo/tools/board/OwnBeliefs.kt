package argo.tools.board

import argo.filters.matching.whyUnreadable
import javino.PerceptTerm

/** ARGO's own beliefs about boards, by functor and number of arguments. */
internal val OWN_BELIEFS = setOf("port/2", "stale/1", "reflex/2")

private val LAST_WORDS = mapOf("port/2" to setOf("on", "off", "timeout"), "reflex/2" to setOf("done", "failed"))

/** Returns why no agent believes [percept]; null: agents do. */
internal fun whyUnbelieved(percept: String): String? = whyUnreadable(percept) ?: PerceptTerm.of(percept).run {
    val words = LAST_WORDS[indicator()]
    val isClaim = indicator() in OWN_BELIEFS && (words == null || arguments().last().substringBefore('[').trim() in words)
    if (isClaim) "${indicator()} is a belief of ARGO's own, which no board can claim" else null
}
