package argo.tools.migration

import argo.filters.FilterException
import argo.filters.format.XmlFilters
import argo.filters.matching.warnings
import java.nio.file.Path
import kotlin.io.path.inputStream
import kotlin.io.path.readText

/**
 * Checks an XML file of a perception filter.
 *
 * @param isForOtherVersion whether the agents that it is read with may be for another version of ARGO
 */
internal class FilterFileCheck(private val file: Path, private val isForOtherVersion: Boolean) {
    private val advices = Advices("$file")

    /** Returns all advices; none if the file is no filter. */
    fun advices(): List<Advice> {
        val text = file.readText(Charsets.ISO_8859_1)
        if ("<PerceptionFilter" !in text) return emptyList()
        try {
            val filter = file.inputStream().use { XmlFilters.read(it, "$file") }
            filter.warnings().forEach { advices.note(1, it, "correct or remove it") }
        } catch (refused: FilterException) {
            val remedy = "correct it; until then argo.change_filter fails and the previous filter stays"
            refused.problems.forEach { advices.change(it.line, "the filter is refused: ${it.message}", remedy, it.column) }
        }
        text.lines().forEachIndexed { index, line -> line(line, index + 1) }
        return advices.all
    }

    private fun line(line: String, number: Int) {
        if (isForOtherVersion && DIFFERS.containsMatchIn(line)) {
            val remedy = "invert the operator if the file relies on that"
            advices.note(number, "NE means differs; some versions of ARGO read it as equals", remedy)
        }
        if ("anotation" in line) advices.note(number, "anotation is read as annotation", "no change is needed")
    }

    private companion object {
        val DIFFERS = Regex("operator\\s*=\\s*[\"']\\s*ne\\s*[\"']", RegexOption.IGNORE_CASE)
    }
}
