package argo.lsp.agents

import argo.check.project.Described
import argo.check.syntax.Directive
import argo.check.syntax.Literal
import argo.check.syntax.Span
import argo.check.syntax.StringTerm
import argo.lsp.project.Occurrence
import argo.lsp.project.Project
import argo.lsp.project.Source
import argo.lsp.text.Text
import org.eclipse.lsp4j.Location
import org.eclipse.lsp4j.Position
import org.eclipse.lsp4j.Range
import java.nio.file.Path
import kotlin.io.path.name
import kotlin.io.path.nameWithoutExtension

/** Finds the definitions and uses of the word at a place in an agent's program. */
internal class Navigation(private val project: Project, private val source: Source, private val words: Words) {
    private val family = project.family(source)

    /** Returns the places that define the word at [offset]. */
    fun definitions(offset: Int): List<Location> {
        val literals = source.program.nodesAt(offset).filterIsInstance<Literal>()
        val literal = literals.lastOrNull { it.name.span.touches(offset) } ?: return file(offset)
        val action = literals.takeWhile { it !== literal }.lastOrNull()?.let { words.actionIn(it.functor) }
        if (action == "change_filter") return filter(literal.functor)
        if (action == "act" || action == "can") {
            val registered = project.robot.registered.filter { it.meaning.name == literal.functor }
            if (registered.isNotEmpty()) return registered.map(::location)
        }
        return source.occurrenceAt(offset)?.let(::definitionsOf).orEmpty()
    }

    /** Returns all places of the belief or goal at [offset]. Includes its definitions if [withDefinitions] is true. */
    fun references(offset: Int, withDefinitions: Boolean): List<Location> {
        val symbol = source.occurrenceAt(offset)?.symbol ?: return emptyList()
        return places { it.symbol == symbol && (withDefinitions || !it.isDefinition) }
    }

    private fun definitionsOf(occurrence: Occurrence): List<Location> {
        val symbol = occurrence.symbol
        val percepts = project.robot.described
            .filter { it.meaning.functor() == symbol.functor && it.meaning.arguments().size == symbol.arity }
        if (!occurrence.isDefinition && percepts.isNotEmpty()) return percepts.map(::location)
        val own = places { it.symbol == symbol && it.isDefinition }
        return own.ifEmpty { places(project.sources) { it.symbol == symbol && it.isDefinition } }
    }

    private fun places(among: List<Source> = family, isMeant: (Occurrence) -> Boolean): List<Location> = among.flatMap { each ->
        each.occurrences.filter(isMeant).map { location(each.text, it.literal.span) }
    }

    /** Returns the place of the file that the filter or include at [offset] names. */
    private fun file(offset: Int): List<Location> {
        val nodes = source.program.nodesAt(offset)
        val name = nodes.filterIsInstance<StringTerm>().lastOrNull()?.text ?: return emptyList()
        val call = nodes.filterIsInstance<Literal>().lastOrNull()
        return when {
            nodes.any { it is Directive } -> project.included(name).map { begin(it.file) }
            call != null && words.actionIn(call.functor) == "change_filter" -> filter(name)
            else -> emptyList()
        }
    }

    private fun filter(name: String) =
        project.filters.filter { it.nameWithoutExtension == name.substringAfterLast('/') || it.name == name }.map(::begin)

    private fun begin(file: Path) = Location(file.toUri().toString(), Range(Position(0, 0), Position(0, 0)))

    private fun location(described: Described<*>) =
        location(Text(described.file.path.toUri().toString(), 0, described.file.text), described.span)

    private fun location(text: Text, span: Span) = Location(text.uri, text.range(span))
}
