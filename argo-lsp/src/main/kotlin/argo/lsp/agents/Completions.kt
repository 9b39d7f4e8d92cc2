package argo.lsp.agents

import argo.check.project.BoardAction
import argo.check.syntax.Span
import argo.lsp.language.completion
import argo.lsp.project.Occurrence
import argo.lsp.project.Project
import argo.lsp.project.Source
import argo.lsp.project.Subject
import javino.PerceptArgument
import javino.PerceptKind
import org.eclipse.lsp4j.CompletionItem
import org.eclipse.lsp4j.CompletionItemKind
import org.eclipse.lsp4j.CompletionItemLabelDetails
import org.eclipse.lsp4j.InsertTextFormat

/** Finds the words that are possible at a cursor in an agent's program. */
internal class Completions(private val project: Project, private val source: Source, offset: Int, private val words: Words) {
    private val cursor = ProgramPlace(source.program, offset)
    private val call = cursor.calls.firstOrNull()
    private val family = project.family(source)
    private val action = words.actionIn(call?.name.orEmpty())

    fun items(): List<CompletionItem> {
        if (cursor.isAside) return emptyList()
        return inCall() ?: when {
            cursor.prefix.endsWith("!") -> goals()
            cursor.prefix.endsWith("?") -> beliefs() + percepts()
            '.' in cursor.text -> actions()
            cursor.region == Region.HEAD -> if (cursor.prefix.isEmpty()) emptyList() else percepts() + beliefs()
            cursor.region == Region.CONTEXT -> percepts() + beliefs() + actions()
            cursor.region == Region.BODY && cursor.prefix.isEmpty() -> actions() + beliefs()
            cursor.region == Region.BODY -> beliefs()
            else -> emptyList()
        }.distinctBy { it.label }
    }

    /** The words for the argument of an action, or of `error(…)`; null if any word is possible. */
    private fun inCall(): List<CompletionItem>? = when {
        call == null -> null
        call.name == "error" && call.argument == 0 ->
            words.errors.map { (error, cause) -> item(error, CompletionItemKind.EnumMember, cause) }
        call.isInList && action == null -> option(cursor.calls.drop(1).firstOrNull())
        action == "change_filter" && call.argument == 0 -> filters()
        action == "act" && call.argument == 0 || action == "can" -> project.robot.registered.map { command(it.meaning) }
        action == "percepts" -> listOf("open", "block", "close").map { item(it, CompletionItemKind.EnumMember, "") }
        action == "age" && call.argument == 0 || action == "explain" && call.argument == 0 -> percepts()
        call.isInList -> option(call)
        else -> null
    }

    private fun option(around: OpenCall?): List<CompletionItem>? =
        words.options[words.actionIn(around?.name.orEmpty())]?.map { (name, meaning) -> item(name, CompletionItemKind.Property, meaning) }

    private fun filters() = (project.filterNames + "none").map { item(it, CompletionItemKind.File, "") }

    private fun command(action: BoardAction) =
        item(action.name, CompletionItemKind.Function, "a command that the board has registered")

    private fun goals(): List<CompletionItem> = symbols(Subject.GOAL, CompletionItemKind.Method)

    private fun beliefs(): List<CompletionItem> = symbols(Subject.BELIEF, CompletionItemKind.Field)

    private fun symbols(subject: Subject, kind: CompletionItemKind): List<CompletionItem> = family
        .flatMap { it.occurrences }.filter { it.symbol.subject == subject && !it.literal.span.touches(cursor.word.end) }
        .groupBy { it.symbol }.map { (symbol, places) ->
            val place = places.firstOrNull { it.isDefinition } ?: places.first()
            item(symbol.functor, kind, "", arguments = place.literal.arguments.size, insert = call(place))
        }

    /** Returns a call of the symbol at [place]. The arguments at [place] become placeholders. */
    private fun call(place: Occurrence): String {
        val arguments = place.literal.arguments.mapIndexed { at, argument -> "\${${at + 1}:${snippetText(textOf(argument.span, place))}}" }
        return callOf(place.symbol.functor, arguments)
    }

    private fun textOf(span: Span, place: Occurrence): String =
        family.first { place in it.occurrences }.text.content.substring(span.start, span.end)

    private fun percepts(): List<CompletionItem> = project.robot.described.map { described ->
        val kind = described.meaning
        item(kind.functor(), CompletionItemKind.Event, "a percept of the board: `$kind`", kind.arguments().size, insertOf(kind))
    }

    private fun actions(): List<CompletionItem> = words.actions.map { (name, page) -> item(name, CompletionItemKind.Function, page) }

    private fun item(label: String, kind: CompletionItemKind, meaning: String, arguments: Int = 0, insert: String = label) =
        completion(label, kind, meaning, source.text, cursor.word).apply {
            if (arguments > 0) labelDetails = CompletionItemLabelDetails().apply { detail = "/$arguments" }
            val isSnippet = insert != label && words.hasSnippets
            insertTextFormat = if (isSnippet) InsertTextFormat.Snippet else InsertTextFormat.PlainText
            if (isSnippet) textEdit.left.newText = insert
        }

    private companion object {
        fun snippetText(text: String) = text.replace("\\", "\\\\").replace("$", "\\$").replace("}", "\\}")

        fun insertOf(kind: PerceptKind): String {
            val arguments = kind.arguments().mapIndexed { at, argument ->
                when (argument) {
                    is PerceptArgument.Choice -> "\${${at + 1}|${argument.choices().joinToString(",")}|}"
                    is PerceptArgument.Quantity -> "\${${at + 1}:${variableOf(argument.unit())}}"
                    else -> "\${${at + 1}:_}"
                }
            }
            return callOf(kind.functor(), arguments)
        }

        fun callOf(functor: String, arguments: List<String>) =
            functor + if (arguments.isEmpty()) "" else arguments.joinToString(", ", "(", ")")

        /** Returns a variable with the name of its unit, such as `Cm`. */
        fun variableOf(unit: String) = unit.filter(Char::isLetter).replaceFirstChar(Char::uppercase).ifEmpty { "Value" }
    }
}
