package argo.filters.format

import argo.filters.Condition
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.TermTest
import argo.filters.filters
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.PropertyTesting
import io.kotest.property.checkAll

class XmlRoundTripSpec : StringSpec({
    "what is written is read back to an equal filter" {
        checkAll(2 * PropertyTesting.defaultIterationCount, filters) { XmlFilters.read(XmlFilters.write(it), "generated.xml") shouldBe it }
    }

    "what is written does not depend on how it was read" {
        checkAll(500, filters) {
            val text = XmlFilters.write(it)
            XmlFilters.write(XmlFilters.read(text, "generated.xml")) shouldBe text
        }
    }

    "a character that XML cannot hold is refused" {
        val filter = PerceptionFilter("f", Rule("d", Condition.Argument(0, TermTest.Compare(Operator.EQ, GroundTerm.Text("\u0001")))))
        shouldThrow<IllegalArgumentException> { XmlFilters.write(filter) }.message shouldContain "U+0001"
    }

    "it is written as the paper writes it" {
        val filter = PerceptionFilter(
            "frontDistance",
            Rule("temperature"),
            Rule("distance", Condition.Argument(0, TermTest.Compare(Operator.NE, GroundTerm.of("front")))),
        )
        XmlFilters.write(filter) shouldBe """
            <?xml version="1.0"?>
            <PerceptionFilter>
              <filter>
                <predicate>temperature</predicate>
              </filter>
              <filter>
                <predicate>distance</predicate>
                <parameter operator="NE" id="0">front</parameter>
              </filter>
            </PerceptionFilter>
        """.trimIndent() + "\n"
    }
})
