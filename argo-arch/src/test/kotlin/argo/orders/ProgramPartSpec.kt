package argo.orders

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import jason.asSyntax.parser.SimpleCharStream
import jason.asSyntax.parser.Token
import jason.asSyntax.parser.as2jConstants
import jason.asSyntax.parser.as2jTokenManager
import java.io.StringReader

class ProgramPartSpec : FunSpec({
    test("a program without some of its parts has blanks there, and is else the same, in each line") {
        val pieces = Arb.element("+!a", "\"x\ty\"", "\t", " ", "\n", "\r\n", "\r", "// c\n", "/* +!b\n\t*/", ".", "dist(F, 3)", "_")
        checkAll(Arb.list(pieces, 0..30)) { drawn ->
            val text = drawn.joinToString("")
            val tokens = tokensOf(text)
            val without = tokens.filterIndexed { place, _ -> place % 2 == 0 }
            val parts = without.map { ProgramPart(Place(it.beginLine, it.beginColumn), Place(it.endLine, it.endColumn)) }
            val shortened = text.without(parts)
            shortened.length shouldBe text.length
            tokensOf(shortened).map(::shown) shouldBe (tokens - without.toSet()).map(::shown)
        }
    }
})

private fun tokensOf(text: String): List<Token> = as2jTokenManager(SimpleCharStream(StringReader(text))).let { manager ->
    generateSequence { manager.nextToken.takeIf { it.kind != as2jConstants.EOF } }.toList()
}

private fun shown(token: Token) = Triple(token.image, token.beginLine, token.beginColumn)
