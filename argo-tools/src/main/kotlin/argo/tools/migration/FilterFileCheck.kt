package argo.tools.migration

import argo.filters.FilterException
import argo.filters.format.XmlFilters
import java.nio.file.Path
import kotlin.io.path.inputStream
import kotlin.io.path.readText

/** What would be otherwise with an XML file of a perception filter. */
internal class FilterFileCheck(private val file: Path) {
    private val advices = Advices("$file")

    /** All that is to be said; nothing if the file is no filter. */
    fun advices(): List<Advice> {
        val text = file.readText(Charsets.ISO_8859_1)
        if ("<PerceptionFilter" !in text) return emptyList()
        try {
            file.inputStream().use { XmlFilters.read(it, "$file") }
        } catch (refused: FilterException) {
            refused.problems.forEach { advices.change(it.line, "the filter is refused: ${it.message}", "mend it; until then argo.change_filter fails and the filter before stays") }
        }
        text.lines().forEachIndexed { index, line -> line(line, index + 1) }
        return advices.all
    }

    private fun line(line: String, number: Int) {
        if (DIFFERS.containsMatchIn(line)) advices.note(number, "NE means differs; some versions of ARGO read it as equals", "if the file was written around that, turn the operator")
        if ("anotation" in line) advices.note(number, "anotation is read as annotation", "nothing need be done")
    }

    private companion object {
        val DIFFERS = Regex("operator\\s*=\\s*[\"']\\s*ne\\s*[\"']", RegexOption.IGNORE_CASE)
    }
}
