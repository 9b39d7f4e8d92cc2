package argo.filters

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.checkAll
import jason.asSyntax.ASSyntax

class LiteralContractSpec : StringSpec({
    "a filter decides over a percept's text as over the literal that Jason reads from it" {
        var dropped = 0
        checkAll(5_000, filters, perceptTexts) { filter, text ->
            val matcher = filter.matcher()
            val decision = matcher.drops(text)
            withClue("$filter on $text") { decision shouldBe matcher.drops(ASSyntax.parseLiteral(text)) }
            if (decision) dropped++
        }
        dropped shouldBeGreaterThan 100
    }
})
