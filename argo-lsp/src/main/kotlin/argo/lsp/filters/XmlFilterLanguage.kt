package argo.lsp.filters

import argo.check.syntax.Span
import argo.lsp.language.Language
import argo.lsp.language.completion
import argo.lsp.text.Text
import org.eclipse.lsp4j.CompletionItem
import org.eclipse.lsp4j.CompletionItemKind
import org.eclipse.lsp4j.Hover

/** Helps with filters in XML, but not with other XML files. */
internal class XmlFilterLanguage(private val words: (Text) -> FilterWords) : Language {
    override fun completions(text: Text, offset: Int): List<CompletionItem> {
        val place = XmlPlace.at(text.content, offset)
        val span = Span(place.begin, offset)
        fun named(kind: CompletionItemKind, named: Named) = completion(named.name, kind, named.documentation, text, span)
        return when (val part = place.part) {
            is XmlPlace.Part.Name ->
                if (part.isEnd) place.open.takeLast(1).map { completion(it, CompletionItemKind.Property, "", text, span) }
                else XmlFilterSchema.elementsIn(place.open).map { named(CompletionItemKind.Property, it.named) }
            is XmlPlace.Part.Attribute ->
                XmlFilterSchema.element(place.open, part.element)?.attributes.orEmpty().map { named(CompletionItemKind.Field, it) }
            is XmlPlace.Part.Value -> values(place, part, words(text)).map { completion(it, CompletionItemKind.Value, "", text, span) }
            XmlPlace.Part.Content -> if (place.open.lastOrNull() == PREDICATE) predicates(text, place, offset) else emptyList()
            XmlPlace.Part.Nothing -> emptyList()
        }
    }

    private fun values(place: XmlPlace, part: XmlPlace.Part.Value, words: FilterWords): List<String> {
        if (part.attribute == REFLEX) return words.actions
        return XmlFilterSchema.element(place.open, part.element)?.attributes?.find { it.name == part.attribute }?.values.orEmpty()
    }

    private fun predicates(text: Text, place: XmlPlace, offset: Int): List<CompletionItem> {
        val begin = (place.begin until offset).find { !text.content[it].isWhitespace() } ?: offset
        val span = Span(begin, offset)
        return words(text).percepts.map { (name, meaning) -> completion(name, CompletionItemKind.Value, meaning, text, span) }
    }

    override fun hover(text: Text, offset: Int): Hover? {
        val end = endOfWord(text.content, offset)
        val place = XmlPlace.at(text.content, end)
        val word = text.content.substring(place.begin.coerceAtMost(end), end).trim()
        val found = when (val part = place.part) {
            is XmlPlace.Part.Name -> XmlFilterSchema.element(place.open, word)?.named
            is XmlPlace.Part.Attribute -> XmlFilterSchema.element(place.open, part.element)?.attributes?.find { it.name == word }
            XmlPlace.Part.Content -> words(text).percepts[word]?.takeIf { place.open.lastOrNull() == PREDICATE }?.let { Named(word, it) }
            else -> null
        }
        return found?.let(::hoverOf)
    }
}
