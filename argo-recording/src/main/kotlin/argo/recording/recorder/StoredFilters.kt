package argo.recording.recorder

import argo.filters.PerceptionFilter
import argo.filters.format.XmlFilters
import argo.recording.filterName

/**
 * The filters of [agent] that its recording holds, in XML, each once. For the agent's thread.
 *
 * @param attach stores a text under a name
 */
internal class StoredFilters(private val agent: String, private val attach: (name: String, text: String) -> Unit) {
    private val names = HashMap<PerceptionFilter, String>()
    private val texts = HashSet<String>()

    /** The name of the attachment with [filter]. */
    fun store(filter: PerceptionFilter): String = names.getOrPut(filter) {
        val name = names(filter.name).first(texts::add)
        attach(name, XmlFilters.write(filter))
        name
    }

    /** A filter may be read anew under its name, when its file has changed. */
    private fun names(filter: String) =
        sequenceOf(filterName(agent, filter)) + generateSequence(2) { it + 1 }.map { filterName(agent, "$filter-$it") }
}
