package experiment

import argo.filters.FilterProvider
import argo.filters.PerceptionFilter
import argo.filters.RuleList
import argo.filters.dropFilter
import argo.filters.keepFilter

/** Makes the filter of [view] with a critical rule. The rule's reflex is `stop` at a front distance of [limit] cm or less. */
internal fun reflexFilter(view: View, limit: Int): PerceptionFilter {
    val name = "${view.word}Reflex$limit"
    val functors = view.functors ?: return dropFilter(name) { stopAt(limit) }
    return keepFilter(name) {
        stopAt(limit)
        functors.forEach { keep(it) { argument(0) eq "f" } }
    }
}

private fun RuleList.stopAt(limit: Int) = critical("dist") {
    argument(0) eq "f"
    argument(1) le limit
    reflex("stop")
}

/**
 * Gives agents the filters of [Condition.REFLEX], one for each limit of a plan and each [View]. Gives no filters before an experiment
 * starts. Agents of other samples in this program then do not see them.
 */
internal class ReflexFilters : FilterProvider {
    override val filters get() = offered

    companion object {
        @Volatile
        private var offered: List<PerceptionFilter> = emptyList()

        fun offer() {
            offered = Plan.entries.flatMap { it.limits }.distinct().flatMap { limit -> View.entries.map { reflexFilter(it, limit) } }
        }
    }
}
