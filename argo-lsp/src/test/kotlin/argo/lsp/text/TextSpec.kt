package argo.lsp.text

import argo.lsp.position
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import org.eclipse.lsp4j.Position
import org.eclipse.lsp4j.Range
import org.eclipse.lsp4j.TextDocumentContentChangeEvent

class TextSpec : FunSpec({
    test("a change of a part leaves what replacing it in the text does, and one without a place replaces all") {
        checkAll(Arb.string(0..40), Arb.list(Arb.int(0..100), 2..2), Arb.string(0..5)) { characters, places, put ->
            val text = characters.replace('a', '\n')
            val (begin, end) = places.map { it % (text.length + 1) }.sorted()
            val change = TextDocumentContentChangeEvent(Range(position(text, begin), position(text, end)), put)
            Text("u", 1, text).changed(2, listOf(change)).content shouldBe text.replaceRange(begin, end, put)
        }
        Text("u", 1, "old").changed(2, listOf(TextDocumentContentChangeEvent("new"))).content shouldBe "new"
    }

    test("a position behind a line or the text is its end") {
        val text = Text("u", 1, "ab\ncd")
        text.offset(Position(0, 99)) shouldBe 2
        text.offset(Position(9, 0)) shouldBe 5
        text.position(4) shouldBe Position(1, 1)
    }
})
