package argo.lsp.projectfile

import argo.check.project.MasFile
import argo.check.syntax.Span
import argo.check.syntax.Token
import argo.check.syntax.TokenKind
import argo.lsp.language.Language
import argo.lsp.language.completion
import argo.lsp.language.markdown
import argo.lsp.project.Project
import argo.lsp.project.fileOf
import argo.lsp.text.Text
import org.eclipse.lsp4j.CompletionItem
import org.eclipse.lsp4j.CompletionItemKind
import org.eclipse.lsp4j.DocumentSymbol
import org.eclipse.lsp4j.Hover
import org.eclipse.lsp4j.Location
import org.eclipse.lsp4j.Position
import org.eclipse.lsp4j.Range
import org.eclipse.lsp4j.SymbolKind
import java.nio.file.Path

/** Jason's project files, `.mas2j`. */
internal class ProjectFileLanguage(private val projectOf: (Text) -> Project) : Language {
    override fun completions(text: Text, offset: Int): List<CompletionItem> {
        val tokens = read(text).tokens
        val word = tokens.lastOrNull { it.span.start < offset && offset <= it.span.end && it.kind == TokenKind.ATOM }
        val span = word?.span?.copy(end = offset) ?: Span(offset, offset)
        val before = tokens.filter { it.span.end <= span.start }
        val isInOptions = before.indexOfLast { it.isSymbol("[") } > before.indexOfLast { it.isSymbol("]") }
        return when {
            tokens.any { it.kind == TokenKind.STRING && it.span.start < offset && offset < it.span.end } -> emptyList()
            before.lastOrNull()?.text == ARCHITECTURE -> listOf(item("argo.Arch", "perceives and acts through boards", text, span))
            isInOptions && before.last().isSymbol("=") -> values(before).map { item(it, "", text, span) }
            isInOptions -> OPTIONS.map { (name, meaning) -> item(name, meaning, text, span) }
            before.lastOrNull()?.let { it.isSymbol("{") || it.isSymbol(";") } != false -> SECTIONS.map { item(it, "", text, span) }
            else -> KEYWORDS.map { item(it, "", text, span) }
        }
    }

    override fun hover(text: Text, offset: Int): Hover? {
        val token = read(text).tokens.find { it.span.touches(offset) && it.text in OPTIONS } ?: return null
        return Hover(markdown("`${token.text}`\n\n${OPTIONS[token.text]}"), text.range(token.span))
    }

    override fun definitions(text: Text, offset: Int): List<Location> {
        val file = read(text)
        val agent = file.agents.find { it.name.span.touches(offset) } ?: return emptyList()
        return listOfNotNull(projectOf(text).checked.sourceOf(file, agent)).map { path ->
            Location(path.toUri().toString(), Range(Position(0, 0), Position(0, 0)))
        }
    }

    override fun symbols(text: Text): List<DocumentSymbol> = read(text).agents.map { agent ->
        val range = text.range(agent.name.span)
        DocumentSymbol(agent.name.text, SymbolKind.Object, range, range, agent.source)
    }

    private fun values(before: List<Token>) =
        if (before.getOrNull(before.size - 2)?.text == "argo_sensing") listOf("fresh", "every", "in_cycle") else emptyList()

    private fun read(text: Text) = MasFile(fileOf(text.uri) ?: Path.of(text.uri.substringAfterLast('/')), text.content)

    private fun item(word: String, meaning: String, text: Text, span: Span) =
        completion(word, CompletionItemKind.Keyword, meaning, text, span)

    private companion object {
        const val ARCHITECTURE = "agentArchClass"

        /** ARGO's options of an agent, with their meanings in Markdown. */
        val OPTIONS = mapOf(
            "argo_sensing" to "when the agent gets a new snapshot of its sensors: `fresh` (default), `every` or `in_cycle`",
            "argo_percepts" to "the most percepts of a board that are believed at once; 4096 by default",
            "argo_view" to "the port of the live view, on this computer; `0`: any free one",
            "argo_watch" to "`true`: the agent is reloaded whenever a file of its program or its filters is saved",
            "argo_safe" to "the command that makes the agent's boards safe before it is paused: `stop`, `\"speed(0)\"`",
            "argo_debug" to "the port at which debuggers reach the agent, on this computer; `0`: any free one",
            "argo_record" to "the file of a recording, `\"drive.mcap\"`, or `\"last(5)\"`: the last five minutes, for `argo.record`",
            "argo_resume" to "the file with the state from which the agent goes on when it begins again, `\"robot.state\"`",
            "argo_fleet" to "the percepts of a fleet that the agent has: `computers`, `agents`, or both, `\"computers,agents\"`",
            "argo_ros" to "the address of a `rosbridge_server`, `\"robot:9090\"`: the agent's boards take part in the ROS graph behind it",
        )
        val SECTIONS = listOf("agents", "environment", "infrastructure", "classpath", "aslSourcePath", "executionControl", "directives")
        val KEYWORDS = listOf(ARCHITECTURE, "agentClass", "beliefBaseClass", "at")
    }
}
