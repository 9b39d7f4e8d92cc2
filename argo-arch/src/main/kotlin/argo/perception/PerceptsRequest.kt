package argo.perception

import argo.acting.isPlain
import argo.filters.PerceptionFilter
import javino.Frame
import javino.PerceptsRequest

/**
 * Returns the request to a board of version 2 while [filter] is active. If the filter passes only percepts with certain functors, the
 * request names them, as in `getPercepts(dist,light)`. Other percepts then take no time on the line. If the filter may pass any functor,
 * the request asks for all percepts.
 */
internal fun perceptsRequest(filter: PerceptionFilter?): String =
    filter?.let(::functorsKept)?.joinToString(",", "${PerceptsRequest.ALL}(", ")")?.takeIf { it.length <= Frame.MAX_PAYLOAD }
        ?: PerceptsRequest.ALL

/** Returns the functors of all percepts that the filter needs; null if it may need any. For a board, `~open` has the functor `open`. */
private fun functorsKept(filter: PerceptionFilter): List<String>? = (filter.rules + filter.critical.map { it.rule })
    .takeIf { filter.mode == PerceptionFilter.Mode.KEEP && it.isNotEmpty() }
    ?.takeIf { rules -> rules.all { it.rate == null && isPlain(it.predicate) } }
    ?.map { it.predicate.functor }?.distinct()
