package argo.lsp.agents

import argo.lsp.language.RefusedException
import argo.lsp.language.Renamed
import argo.lsp.project.Occurrence
import argo.lsp.project.Project
import argo.lsp.project.Source
import org.eclipse.lsp4j.TextEdit
import org.eclipse.lsp4j.WorkspaceEdit

/** Renames beliefs and goals in all programs of the agents that use [source]. */
internal class Renaming(private val project: Project, private val source: Source) {
    /**
     * Returns the belief or goal at [offset]; null if there is none.
     *
     * @throws RefusedException if the name is also used outside of the agent's programs
     */
    fun renamedAt(offset: Int): Occurrence? {
        val occurrence = source.occurrenceAt(offset) ?: return null
        val symbol = occurrence.symbol
        val described = project.robot.described.find { it.meaning.functor() == symbol.functor }
        if (described != null) {
            throw RefusedException("${symbol.functor} is a percept of the board: its name is in ${described.file.path.fileName}")
        }
        val namespaces = placesOf(occurrence).map { (_, place) -> place.namespace }.distinct()
        if (namespaces.size > 1) {
            val written = namespaces.joinToString { it.ifEmpty { "none" } }
            throw RefusedException("$symbol is in several namespaces ($written), and may be several things: rename them by hand")
        }
        return occurrence
    }

    fun rename(occurrence: Occurrence, name: String): Renamed {
        if (!ATOM.matches(name)) {
            val kind = occurrence.symbol.subject.word
            throw RefusedException("$name cannot be the name of a $kind: write a letter from a to z, then letters, digits and _")
        }
        val edits = placesOf(occurrence).groupBy({ (each, _) -> each.text.uri }) { (each, place) ->
            TextEdit(each.text.range(place.name), name)
        }
        val left = (sentByOthers(occurrence) + initialIn(occurrence)).joinToString()
        return Renamed(WorkspaceEdit(edits), "other files still name ${occurrence.symbol}: $left".takeIf { left.isNotEmpty() })
    }

    /** Returns the messages with the name of [occurrence] in programs of other agents. A renaming does not change these messages. */
    private fun sentByOthers(occurrence: Occurrence): List<String> {
        val family = project.family(source)
        return project.sources.filter { it !in family }.flatMap { each ->
            each.occurrences.filter { it.isSent && it.symbol == occurrence.symbol }.map { place ->
                "${each.file.fileName}:${each.program.lines.position(place.literal.span.start).line}"
            }
        }
    }

    /** Returns the agents in project files with the name in their option `beliefs` or `goals`. A renaming does not change options. */
    private fun initialIn(occurrence: Occurrence): List<String> {
        val agents = project.checked.agentsOf(source.file)
        return project.checked.masFiles.flatMap { mas ->
            mas.agents.filter { it in agents && it.initial.any { mention -> Occurrence.of(mention)?.symbol == occurrence.symbol } }
                .map { "${mas.path.fileName}:${mas.lines.position(it.name.span.start).line}" }
        }
    }

    private fun placesOf(occurrence: Occurrence): List<Pair<Source, Occurrence>> =
        project.family(source).flatMap { each -> each.occurrences.filter { it.symbol == occurrence.symbol }.map { each to it } }

    private companion object {
        val ATOM = Regex("[a-z][A-Za-z0-9_]*")
    }
}
