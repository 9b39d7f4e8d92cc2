package argo.lsp.agents

import argo.check.syntax.Literal
import argo.check.syntax.TokenKind
import argo.lsp.language.markdown
import argo.lsp.live.LiveValues
import argo.lsp.project.Occurrence
import argo.lsp.project.Project
import argo.lsp.project.Source
import argo.lsp.project.Subject
import argo.tools.command.counted
import org.eclipse.lsp4j.Hover
import kotlin.io.path.name

/** Explains the word under the cursor. */
internal class Hovers(private val project: Project, private val source: Source, private val words: Words, private val live: LiveValues) {
    fun at(offset: Int): Hover? {
        val token = source.program.tokenAt(offset)?.takeIf { it.kind == TokenKind.ATOM } ?: return null
        val literals = source.program.nodesAt(offset).filterIsInstance<Literal>().filter { it.name.span.touches(offset) }
        val literal = literals.lastOrNull() ?: return null
        val around = source.program.nodesAt(offset).filterIsInstance<Literal>().takeWhile { it !== literal }.lastOrNull()
        val text = when {
            literal.isInternal -> words.actionIn(literal.functor)?.let { words.actions["argo.$it"] } ?: words.actions[literal.functor]
            around?.functor == "error" -> words.errors[literal.functor]
            else -> command(around, literal) ?: symbol(literal)
        } ?: return null
        return Hover(markdown(text), source.text.range(token.span))
    }

    private fun command(around: Literal?, literal: Literal): String? {
        if (around == null || words.actionIn(around.functor) !in COMMANDS) return null
        val described = project.robot.registered.find { it.meaning.name == literal.functor } ?: return null
        return "`${literal.functor}`: a command that the board has registered, ${described.file.path.name}"
    }

    private fun symbol(literal: Literal): String? {
        val kinds = project.robot.described.filter { it.meaning.functor() == literal.functor }
        val kind = kinds.find { it.meaning.arguments().size == literal.arity }
        val occurrence = source.occurrences.find { it.literal === literal }
        return when {
            kind != null -> percept("${kind.meaning}", kind.file.path.name, literal)
            occurrence == null -> null
            kinds.isNotEmpty() -> "`${literal.indicator}` is no percept of the board, but: ${kinds.joinToString { "`${it.meaning}`" }}"
            else -> places(occurrence)
        }
    }

    private fun percept(kind: String, file: String, literal: Literal): String {
        val values = lastValues(literal).joinToString("") { "\n\nnow: `$it`" }
        return "`$kind`\n\na percept of the board, described in $file$values"
    }

    /** Returns current percepts or beliefs of agents that run the program. The agents must have a live view at a fixed port. */
    private fun lastValues(literal: Literal): List<String> = project.checked.agentsOf(source.file).flatMap { agent ->
        val port = agent.options.find { it.name.text == "argo_view" }?.value?.text?.toIntOrNull()?.takeIf { it in PORTS }
        port?.let { agent.names.flatMap { name -> live.of(port, name, literal.functor, literal.arity) } }.orEmpty()
    }

    private fun places(occurrence: Occurrence): String {
        val family = project.family(source)
        val definitions = family.flatMap { each -> each.occurrences.filter { it.symbol == occurrence.symbol && it.isDefinition } }
        val uses = family.sumOf { each -> each.occurrences.count { it.symbol == occurrence.symbol && it.isUse } }
        val what = if (occurrence.symbol.subject == Subject.GOAL) "plan" else "origin"
        val comment = family.firstNotNullOfOrNull { each -> definitions.firstNotNullOfOrNull { commentAbove(each, it) } }
        return "`${occurrence.symbol}`\n\n" + comment?.let { "$it\n\n" }.orEmpty() +
            "${occurrence.symbol.subject.word}: ${counted(definitions.size, what)}, ${counted(uses, "use")} in this agent"
    }

    private fun commentAbove(source: Source, definition: Occurrence): String? {
        if (definition !in source.occurrences) return null
        val begin = source.program.components.find { it.span.touches(definition.literal.span.start) }?.span?.start ?: return null
        val lines = source.program.lines
        val above = source.program.tokens.filter { it.kind == TokenKind.COMMENT && it.span.end <= begin }
        var line = lines.position(begin).line
        val found = ArrayDeque<String>()
        for (comment in above.asReversed()) {
            if (lines.position(comment.span.end).line != line - 1) break
            line = lines.position(comment.span.start).line
            found.addFirst(comment.text.removePrefix("//").removeSurrounding("/*", "*/").trim())
        }
        return found.joinToString("\n").ifEmpty { null }
    }

    private companion object {
        val COMMANDS = setOf("act", "can")
        val PORTS = 1..65_535
    }
}
