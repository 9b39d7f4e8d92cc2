package argo.perception

import argo.acting.isPlain
import argo.filters.PerceptionFilter
import javino.Frame
import javino.PerceptsRequest

/**
 * What a board of version 2 is asked for while [filter] is active: `getPercepts(dist,light)` if percepts of these functors are all that the
 * filter lets through, so that the others take no time on the line; otherwise everything.
 */
internal fun perceptsRequest(filter: PerceptionFilter?): String =
    filter?.let(::functorsKept)?.joinToString(",", "${PerceptsRequest.ALL}(", ")")?.takeIf { it.length <= Frame.MAX_PAYLOAD }
        ?: PerceptsRequest.ALL

/** The functors without whose percepts the filter decides as it would with them; null: it may need any. `~open` is sent under `open`. */
private fun functorsKept(filter: PerceptionFilter): List<String>? = (filter.rules + filter.critical.map { it.rule })
    .takeIf { filter.mode == PerceptionFilter.Mode.KEEP && it.isNotEmpty() }
    ?.takeIf { rules -> rules.all { it.rate == null && isPlain(it.predicate) } }
    ?.map { it.predicate.functor }?.distinct()
