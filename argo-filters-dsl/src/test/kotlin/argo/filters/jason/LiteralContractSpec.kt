package argo.filters.jason

import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.filters
import argo.filters.matching.matcher
import argo.filters.perceptTexts
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import io.kotest.property.checkAll
import jason.asSyntax.ASSyntax
import jason.asSyntax.Atom
import jason.asSyntax.Literal
import jason.asSyntax.LiteralImpl
import jason.asSyntax.NumberTermImpl
import jason.asSyntax.StringTermImpl
import jason.asSyntax.VarTerm

class LiteralContractSpec : StringSpec({
    "a filter decides over a percept's text as over the literal that Jason reads from it" {
        var dropped = 0
        checkAll(5 * PropertyTesting.defaultIterationCount, filters, perceptTexts) { filter, text ->
            val matcher = filter.matcher()
            val decision = matcher.drops(text)
            withClue("$filter on $text") { decision shouldBe matcher.drops(perceptText(ASSyntax.parseLiteral(text))) }
            if (decision) dropped++
        }
        dropped shouldBeGreaterThan 100
    }

    "a literal that no text could stand for is kept, whatever the filter" {
        val matchers =
            listOf(PerceptionFilter("k", emptyList(), PerceptionFilter.Mode.KEEP), PerceptionFilter("d", Rule("true"))).map { it.matcher() }
        val literals = listOf(
            VarTerm("X"), LiteralImpl(Literal.LNeg, "true"), LiteralImpl("No functor"),
            LiteralImpl(Atom("No namespace"), Literal.LPos, "d"), LiteralImpl(VarTerm("N"), Literal.LPos, "d"),
        )
        for (literal in literals) for (matcher in matchers) withClue("$literal") { matcher.drops(perceptText(literal)) shouldBe false }
    }

    "the text of a literal is one that a board could send, with quotes and line breaks escaped" {
        for (text in listOf("say(\"a \\\"b\\\"\\n\")", "d(-5)", "d([a,\"x\",[b]])", "house::~d(f(1))[q(0.5)]", "d(1e999)", "d(-(1e999))")) {
            val literal = ASSyntax.parseLiteral(text)
            withClue(text) { ASSyntax.parseLiteral(perceptText(literal)) shouldBe literal }
        }
        perceptText(ASSyntax.createLiteral("d", StringTermImpl("a\rb"), NumberTermImpl(1.0))) shouldBe "d(\"a\\u000Db\",1)"
    }
})
