package argo.perception

import argo.filters.PerceptionFilter
import argo.filters.Predicate
import javino.Frame
import javino.PerceptsRequest

/**
 * What a board of version 2 is asked for while [filter] is active: `getPercepts(dist,light)` if percepts of these functors are all that the
 * filter lets through, so that the others take no time on the line; otherwise everything.
 */
internal fun perceptsRequest(filter: PerceptionFilter?): String =
    filter?.let(::functorsKept)?.joinToString(",", "${PerceptsRequest.ALL}(", ")")?.takeIf { it.length <= Frame.MAX_PAYLOAD }
        ?: PerceptsRequest.ALL

/** The functors without whose percepts the filter decides as it would with them; null: it may need any. */
private fun functorsKept(filter: PerceptionFilter): List<String>? = (filter.rules + filter.critical.map { it.rule })
    .takeIf { filter.mode == PerceptionFilter.Mode.KEEP && it.isNotEmpty() }
    ?.takeIf { rules -> rules.all { it.rate == null && isName(it.predicate) } }
    ?.map { it.predicate.functor }?.distinct()

/** A board knows names, no quotes and no namespaces; `~open` is sent under the name `open`. */
private fun isName(predicate: Predicate) =
    predicate.namespace == Predicate.DEFAULT_NAMESPACE && predicate.functor.matches(NAME)

private val NAME = Regex("[a-z][A-Za-z0-9_]*")
