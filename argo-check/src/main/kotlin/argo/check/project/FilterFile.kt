package argo.check.project

import argo.check.findings.Place
import argo.check.syntax.Position
import argo.filters.FilterException
import argo.filters.PerceptionFilter
import argo.filters.Problem
import argo.filters.format.JsonFilters
import argo.filters.format.XmlFilters
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.name

/**
 * A file with a filter, in XML or JSON.
 *
 * @property filter null if it is refused
 * @property problems the reasons why it is refused
 */
class FilterFile private constructor(val path: Path, val text: String, val filter: PerceptionFilter?, val problems: List<Problem>) {
    /** The name by which an agent calls it. */
    val name: String get() = path.name.substringBeforeLast('.')

    /** Returns a place in [line] from [column] on, each counted from 1. */
    fun place(line: Int, column: Int = 1): Place = Place(path, Position(line, column), Position(line, column + 1))

    companion object {
        private val MARKS = mapOf("xml" to "<PerceptionFilter", "json" to "\"rules\"")

        /** Returns the filter file at [path]; null: its [text] is none. */
        internal fun of(path: Path, text: String): FilterFile? {
            if (MARKS.getValue(path.extension) !in text) return null
            return try {
                val filter = text.byteInputStream().use { input ->
                    if (path.extension == "xml") XmlFilters.read(input, "$path") else JsonFilters.read(input, "$path")
                }
                FilterFile(path, text, filter, emptyList())
            } catch (refused: FilterException) {
                FilterFile(path, text, null, refused.problems)
            }
        }
    }
}
