package argo.tools.board

import argo.filters.matching.whyClaimed
import argo.filters.matching.whyUnreadable
import javino.PerceptTerm

/** Returns the reason why no agent believes [percept], or null if agents believe it. */
internal fun whyUnbelieved(percept: String): String? = whyUnreadable(percept) ?: PerceptTerm.of(percept).run {
    whyClaimed(indicator(), arguments().lastOrNull()?.substringBefore('[')?.trim())
}
