package argo.lsp.filters

import argo.check.syntax.Span
import argo.lsp.language.Language
import argo.lsp.language.completion
import argo.lsp.text.Text
import org.eclipse.lsp4j.CompletionItem
import org.eclipse.lsp4j.CompletionItemKind
import org.eclipse.lsp4j.Hover

/** Helps with filters in JSON, but not with other JSON files. */
internal class JsonFilterLanguage(private val words: (Text) -> FilterWords) : Language {
    override fun completions(text: Text, offset: Int): List<CompletionItem> {
        val place = JsonPlace.at(text.content, offset)
        val span = Span(place.begin, offset)
        fun quoted(word: String) = if (place.isQuoted) word.removeSurrounding("\"") else word
        if (place.isName) {
            return JsonFilterSchema.members(place.path)
                .map { completion(quoted("\"${it.name}\""), CompletionItemKind.Property, it.documentation, text, span) }
        }
        val known = when (place.path.lastOrNull()) {
            PREDICATE -> words(text).percepts.mapKeys { (name, _) -> "\"$name\"" }
            REFLEX -> words(text).actions.associate { "\"$it\"" to "" }
            else -> JsonFilterSchema.values(place.path).associateWith { "" }
        }
        return known.map { (word, meaning) -> completion(quoted(word), CompletionItemKind.Value, meaning, text, span) }
    }

    override fun hover(text: Text, offset: Int): Hover? {
        val end = endOfWord(text.content, offset)
        val place = JsonPlace.at(text.content, end)
        val word = text.content.substring(place.begin, end)
        if (place.isName) return JsonFilterSchema.member(place.path + word)?.let(::hoverOf)
        return words(text).percepts[word]?.takeIf { place.path.lastOrNull() == PREDICATE }?.let { hoverOf(Named(word, it)) }
    }
}
