package argo

import argo.filters.PerceptMatcher
import argo.filters.PerceptionFilter
import argo.filters.drops
import argo.filters.matcher
import jason.asSyntax.Literal

/**
 * The filter that an agent perceives through, or none. Immutable; one object for each time a filter is chosen.
 */
internal class ActiveFilter private constructor(private val matcher: PerceptMatcher?) {
    /** Whether the percept with text [percept] is kept from the agent. */
    fun drops(percept: String): Boolean = matcher != null && matcher.drops(percept)

    /** Whether [percept] is kept from the agent. */
    fun drops(percept: Literal): Boolean = matcher != null && matcher.drops(percept)

    companion object {
        /** Lets everything through. */
        val NONE = ActiveFilter(null)

        /** Keeps from the agent what [filter] drops. */
        fun of(filter: PerceptionFilter) = ActiveFilter(filter.matcher())
    }
}
