package argo.recording.recorder

import argo.filters.PerceptionFilter
import argo.filters.format.XmlFilters
import argo.recording.filterName

/** Stores each filter of [agent] once in its recording, in XML. For the agent's thread. */
internal class StoredFilters(private val agent: String, private val attach: (name: String, text: String) -> Unit) {
    private val names = HashMap<PerceptionFilter, String>()
    private val texts = HashSet<String>()

    fun store(filter: PerceptionFilter): String = names.getOrPut(filter) {
        val name = names(filter.name).first(texts::add)
        attach(name, XmlFilters.write(filter))
        name
    }

    /** Returns possible names of the attachment. If the file of a filter changes, the changed filter gets another attachment. */
    private fun names(filter: String) =
        sequenceOf(filterName(agent, filter)) + generateSequence(2) { it + 1 }.map { filterName(agent, "$filter-$it") }
}
