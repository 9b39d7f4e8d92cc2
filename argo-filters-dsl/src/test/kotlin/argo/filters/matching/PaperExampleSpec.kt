package argo.filters.matching

import argo.filters.format.XmlFilters
import argo.filters.jason.perceptText
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import jason.asSyntax.ASSyntax

/** Tests the example of the ARGO paper: Figure 1 has the percepts, and Figure 2 the filter. */
class PaperExampleSpec : StringSpec({
    val filter = XmlFilters.read(
        """
        <?xml version="1.0"?>
        <PerceptionFilter>
          <filter>
            <predicate>temperature</predicate>
          </filter>
          <filter>
            <predicate>light</predicate>
          </filter>
          <filter>
            <predicate>distance</predicate>
            <parameter operator="NE" id="0">front</parameter>
          </filter>
        </PerceptionFilter>
        """.trimIndent(),
        "filters/frontDistance.xml",
    )
    val percepts =
        listOf("temperature(right,36)", "temperature(back,38)", "light(left,143)", "distance(front,227)", "distance(right,30)")

    "it leaves exactly the front distance" {
        percepts.filterNot(filter.matcher()::drops) shouldBe listOf("distance(front,227)")
    }

    "it leaves the same of the percepts as literals" {
        val matcher = filter.matcher()
        percepts.map(ASSyntax::parseLiteral).filterNot { matcher.drops(perceptText(it)) }.map { "$it" } shouldBe
            listOf("distance(front,227)")
    }

    "it is called as its file is" { filter.name shouldBe "frontDistance" }

    "it says what it does" {
        "$filter" shouldBe "filter frontDistance drops temperature; light; distance where argument 0 is not front"
    }
})
