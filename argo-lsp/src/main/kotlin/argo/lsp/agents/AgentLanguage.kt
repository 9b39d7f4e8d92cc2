package argo.lsp.agents

import argo.lsp.language.Language
import argo.lsp.language.Renamed
import argo.lsp.live.LiveValues
import argo.lsp.project.Project
import argo.lsp.project.Source
import argo.lsp.text.Text
import org.eclipse.lsp4j.CompletionItem
import org.eclipse.lsp4j.DocumentSymbol
import org.eclipse.lsp4j.Hover
import org.eclipse.lsp4j.Location
import org.eclipse.lsp4j.Range
import org.eclipse.lsp4j.TextEdit

internal class AgentLanguage(private val projectOf: (Text) -> Project, private val words: () -> Words) : Language {
    private val live = LiveValues()

    override fun completions(text: Text, offset: Int): List<CompletionItem> =
        with(text) { project, source -> Completions(project, source, offset, words()).items() }

    override fun hover(text: Text, offset: Int): Hover? =
        with(text) { project, source -> Hovers(project, source, words(), live).at(offset) }

    override fun definitions(text: Text, offset: Int): List<Location> =
        with(text) { project, source -> Navigation(project, source, words()).definitions(offset) }

    override fun references(text: Text, offset: Int, withDefinitions: Boolean): List<Location> =
        with(text) { project, source -> Navigation(project, source, words()).references(offset, withDefinitions) }

    override fun renamed(text: Text, offset: Int): Range? =
        with(text) { project, source -> Renaming(project, source).renamedAt(offset)?.let { text.range(it.name) } }

    override fun rename(text: Text, offset: Int, name: String): Renamed? = with(text) { project, source ->
        val renaming = Renaming(project, source)
        renaming.renamedAt(offset)?.let { renaming.rename(it, name) }
    }

    override fun symbols(text: Text): List<DocumentSymbol> = with(text) { _, source -> outlineOf(source.program, text) }

    override fun layout(text: Text): List<TextEdit> =
        with(text) { _, source -> formattingOf(source.program).map { TextEdit(text.range(it.span), it.text) } }

    private fun <T> with(text: Text, work: (Project, Source) -> T): T = projectOf(text).let { work(it, it.sourceOf(text)) }
}
