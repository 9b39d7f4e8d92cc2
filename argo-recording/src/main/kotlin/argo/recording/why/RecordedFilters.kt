package argo.recording.why

import argo.filters.FilterException
import argo.filters.format.XmlFilters
import argo.filters.matching.CriticalPercept
import argo.filters.matching.Explanation
import argo.filters.matching.FilterSession
import argo.recording.FilterChange

/**
 * The filters through which an agent perceives at the current cycle of its recording. [files] are the files in the recording, by their
 * names.
 */
internal class RecordedFilters(private val files: Map<String, ByteArray>) {
    private var ofAll: FilterSession<String>? = null
    private val ofBoards = HashMap<String, FilterSession<String>?>()

    fun changed(changes: List<FilterChange>) = changes.forEach { change ->
        val port = change.port
        if (port == null) {
            ofAll = sessionOf(change)
            ofBoards.clear()
        } else {
            ofBoards[port] = sessionOf(change)
        }
    }

    /**
     * Returns the percepts of a message that meet critical rules of the filter for [port], each with its rule. Smoothed rules apply to
     * [kept], all others to [texts].
     */
    fun critical(port: String, texts: List<String>, kept: List<String>): List<CriticalPercept<String>> {
        val filter = of(port)?.filter?.takeIf { it.critical.isNotEmpty() } ?: return emptyList()
        fun met(percepts: List<String>) = FilterSession.ofTexts().apply { switchTo(filter) }.perceive(percepts, 0).critical
        return met(texts).filterNot { it.rule.smoothed } + met(kept).filter { it.rule.smoothed }
    }

    /**
     * Explains why the filter of the board on [port] keeps or drops [text]; null if there is no filter. Rates and smoothing rules also
     * depend on earlier percepts, which are not known here.
     */
    fun explain(port: String, text: String): Explanation? = of(port)?.explain(text, 0)

    private fun of(port: String) = if (port in ofBoards) ofBoards[port] else ofAll

    private fun sessionOf(change: FilterChange): FilterSession<String>? {
        val text = files[change.file ?: return null] ?: return null
        return try {
            FilterSession.ofTexts().apply { switchTo(XmlFilters.read(text.decodeToString(), "${change.name}.xml")) }
        } catch (_: FilterException) {
            null // a filter of a later version
        }
    }
}
