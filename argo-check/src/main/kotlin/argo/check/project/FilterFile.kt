package argo.check.project

import argo.check.findings.Place
import argo.check.syntax.Lines
import argo.check.syntax.Position
import argo.filters.FilterException
import argo.filters.PerceptionFilter
import argo.filters.Problem
import argo.filters.format.JsonFilters
import argo.filters.format.XmlFilters
import com.fasterxml.jackson.core.JsonFactory
import com.fasterxml.jackson.core.JsonProcessingException
import com.fasterxml.jackson.core.JsonStreamContext
import com.fasterxml.jackson.core.JsonToken
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.name

/**
 * A filter file in XML or JSON.
 *
 * @property filter the filter, or null if the file is refused
 * @property problems the reasons for the refusal
 */
class FilterFile private constructor(val path: Path, val text: String, val filter: PerceptionFilter?, val problems: List<Problem>) {
    /** The filter's name for agents. */
    val name: String get() = path.name.substringBeforeLast('.')

    private val lines by lazy { Lines(text) }

    /** Returns the place of the word or tag at [column] of [line]. [line] and [column] count from 1. */
    fun place(line: Int, column: Int = 1): Place {
        val begin = lines.offset(Position(line, column))
        val end = (begin + 1..text.length).find { it == text.length || text[it] in ENDS } ?: begin
        return Place(path, lines.position(begin), lines.position(end))
    }

    companion object {
        private const val FOLDER = "filters"
        private val ROOT =
            Regex("(?:\\s++|\uFEFF|<\\?.*?\\?>|<!--.*?-->|<!DOCTYPE[^>]*>)*+<PerceptionFilter\\b.*", RegexOption.DOT_MATCHES_ALL)
        private const val ENDS = "<>\"',{}[]\n\r"
        private val LISTS = setOf("rules", "critical")

        internal fun of(path: Path, text: String): FilterFile = try {
            val filter = text.byteInputStream().use { input ->
                if (path.extension == "xml") XmlFilters.read(input, "$path") else JsonFilters.read(input, "$path")
            }
            FilterFile(path, text, filter, emptyList())
        } catch (refused: FilterException) {
            FilterFile(path, text, null, refused.problems)
        }

        /**
         * Returns true if [text], the content of the file at [path], is probably a filter. [called] contains the names of filters that
         * programs use.
         */
        internal fun isMeant(path: Path, text: String, called: Set<String>): Boolean =
            path.parent?.name == FOLDER || path.name in called || path.name.substringBeforeLast('.') in called ||
                if (path.extension == "xml") ROOT.matches(text) else hasRules(text)

        /**
         * Returns true if the JSON document [text] has a list with an object that has a predicate. Other documents also have lists named
         * rules.
         */
        private fun hasRules(text: String): Boolean = try {
            JsonFactory().createParser(text).use { parser ->
                generateSequence(parser::nextToken).any {
                    it == JsonToken.FIELD_NAME && parser.currentName() == "predicate" && isInRules(parser.parsingContext)
                }
            }
        } catch (_: JsonProcessingException) {
            false
        }

        private fun isInRules(rule: JsonStreamContext): Boolean {
            val list = rule.parent
            return list.inArray() && list.parent.inObject() && list.parent.currentName in LISTS && list.parent.parent.inRoot()
        }
    }
}
