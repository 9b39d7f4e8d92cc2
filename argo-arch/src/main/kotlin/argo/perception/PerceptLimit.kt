package argo.perception

import argo.platform.RateLimitedWarning
import jason.asSyntax.Literal

/**
 * Limits how many percepts of a board an agent believes at once. Critical percepts are chosen first, then others in the order of the
 * message. The rest is left out. The log warns once, and warns again only after [RateLimitedWarning.QUIET_MS] without excess. Not safe for
 * use by several threads at once.
 *
 * @param max the largest number of percepts
 * @param warning logs that the limit is exceeded
 */
internal class PerceptLimit(private val max: Int, private val warning: RateLimitedWarning) {
    /** Chooses [max] different percepts in [percepts], first those in [critical], and returns them in the order of [percepts]. */
    fun limited(percepts: List<Literal>, critical: Collection<Literal>): List<Literal> {
        if (percepts.size <= max) return percepts
        val different = percepts.distinct()
        if (different.size <= max) return different
        warning.report("limit") {
            "the board sends ${different.size} percepts at once, of which $max are believed; [$OPTION=N] in the .mas2j sets another limit"
        }
        val first = critical.take(max).toHashSet()
        var room = max - first.size
        return different.filter { it in first || room-- > 0 }
    }

    companion object {
        const val OPTION = "argo_percepts"

        /** The default limit. A board cannot send as many percepts in a second at 115200 baud. */
        const val DEFAULT = 4096
    }
}
