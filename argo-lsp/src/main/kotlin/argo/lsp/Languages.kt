package argo.lsp

import argo.check.syntax.programOf
import argo.lsp.agents.ActionManual
import argo.lsp.agents.AgentLanguage
import argo.lsp.agents.JasonManual
import argo.lsp.agents.Words
import argo.lsp.filters.FilterWords
import argo.lsp.filters.JsonFilterLanguage
import argo.lsp.filters.XmlFilterLanguage
import argo.lsp.language.Language
import argo.lsp.project.Projects
import argo.lsp.projectfile.ProjectFileLanguage
import argo.lsp.text.OpenTexts
import argo.lsp.text.Text
import argo.tools.command.classPathWithJason
import org.eclipse.lsp4j.Diagnostic

/**
 * Finds the language of a text by the ending of its file's name. Any thread may call [of]. Only the server's worker thread may call other
 * functions. [tell] shows a line to the user.
 */
internal class Languages(texts: OpenTexts, tell: (String) -> Unit) {
    private val projects = Projects(texts, tell)
    private val findings = Findings(projects)

    /** True if the editor treats `${1:X}` in inserted text as a placeholder. */
    @Volatile
    var hasSnippets = false

    private val words by lazy {
        Words(JasonManual(classPathWithJason(null)).actions + ActionManual.actions, ActionManual.errors, ActionManual.options, hasSnippets)
    }

    private val byEnding = mapOf(
        "asl" to AgentLanguage(projects::of, { words }),
        "mas2j" to ProjectFileLanguage(projects::of),
        "xml" to XmlFilterLanguage(::filterWords),
        "json" to JsonFilterLanguage(::filterWords),
    )

    /** Returns the language of [uri]; null if this server does not support the file's ending. */
    fun of(uri: String): Language? = byEnding[uri.substringAfterLast('.')]

    fun diagnostics(text: Text): List<Diagnostic> = if (of(text.uri) == null) emptyList() else findings.of(text)

    /** Does the work that follows a change of [text], and drops the result. */
    fun rehearse(text: Text) {
        programOf(text.content)
        diagnostics(text)
    }

    /** Call this function after files were created, deleted or changed on the disk. */
    fun filesChanged() = projects.forget()

    private fun filterWords(text: Text): FilterWords {
        val robot = projects.of(text).robot
        val percepts = robot.described.groupBy({ it.meaning.functor() }) { "`${it.meaning}`" }
        val meanings = percepts.mapValues { (_, kinds) -> "percepts of the board: ${kinds.joinToString()}" }
        return FilterWords(meanings, robot.registered.map { it.meaning.name })
    }
}
