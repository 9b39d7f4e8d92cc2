package argo.filters.matching

import argo.filters.Condition
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Predicate
import argo.filters.Rule
import argo.filters.TermTest
import argo.filters.format.XmlFilters
import argo.filters.jason.literalSession
import argo.filters.rates
import io.kotest.core.spec.style.FreeSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import jason.asSyntax.ASSyntax

private fun session(rules: String, root: String = ""): Played<String> = Played(FilterSession.ofTexts()).also {
    it.switchTo(XmlFilters.read("<PerceptionFilter $root>$rules</PerceptionFilter>", "test.xml"))
}

private const val EVERY_100 = "<filter everyMs='100'><predicate>dist</predicate></filter>"
private const val WITHIN_5 = "<filter><predicate>dist</predicate><parameter id='1' deadband='5'/></filter>"

class FilterSessionSpec : FreeSpec({
    "without a filter everything is perceived" {
        FilterSession.ofTexts().perceive(listOf("a", "b(1)", "not a percept"), 0).kept shouldContainExactly
            listOf("a", "b(1)", "not a percept")
    }

    "a filter without rates decides over each percept by itself" {
        val session = session("<filter><predicate>light</predicate></filter>")
        session.perceive(listOf("light(1)", "dist(1)", "("), 0) shouldContainExactly listOf("dist(1)", "(")
        session.nextDueMs shouldBe null
        session.due(1_000_000) shouldBe null
    }

    "with an interval" - {
        "at most one is let through in it, and the last one stands for those that are held back" {
            val session = session(EVERY_100)
            session.perceive(listOf("dist(f,1)", "light(1)"), 0) shouldContainExactly listOf("dist(f,1)", "light(1)")
            session.perceive(listOf("dist(f,2)", "light(2)"), 50) shouldContainExactly listOf("dist(f,1)", "light(2)")
            session.perceive(listOf("dist(f,3)"), 99) shouldContainExactly listOf("dist(f,1)")
            session.perceive(listOf("dist(f,4)"), 100) shouldContainExactly listOf("dist(f,4)")
            session.perceive(listOf("dist(f,5)"), 199) shouldContainExactly listOf("dist(f,4)")
        }

        "the last one that was held back is delivered when it ends, though nothing new comes" {
            val session = session(EVERY_100)
            session.perceive(listOf("dist(f,1)", "light(1)"), 0)
            session.perceive(listOf("dist(f,2)", "light(2)"), 50)
            session.nextDueMs shouldBe 100
            session.due(99) shouldBe null
            session.due(100)!! shouldContainExactly listOf("dist(f,2)", "light(2)")
            session.nextDueMs shouldBe null
            session.due(200) shouldBe null
        }

        "an interval without an end holds back for good" {
            val session = session("<filter everyMs='${Long.MAX_VALUE}'><predicate>dist</predicate></filter>")
            session.perceive(listOf("dist(f,1)"), 50)
            session.perceive(listOf("dist(f,2)"), 100) shouldContainExactly listOf("dist(f,1)")
            session.nextDueMs shouldBe Long.MAX_VALUE
        }

        "each percept counts by itself, up to its numbers" {
            val session = session(EVERY_100)
            session.perceive(listOf("dist(f,1)"), 0)
            session.perceive(listOf("dist(f,2)", "dist(b,2)", "dist(\"f\",2)", "dist(f)"), 50) shouldContainExactly
                listOf("dist(f,1)", "dist(b,2)", "dist(\"f\",2)", "dist(f)")
            session.nextDueMs shouldBe 100
        }

        "a percept that is no longer sent is no longer perceived, and nothing of it is delivered later" {
            val session = session(EVERY_100)
            session.perceive(listOf("dist(f,1)"), 0)
            session.perceive(listOf("dist(f,2)"), 50)
            session.perceive(emptyList(), 60).shouldBeEmpty()
            session.nextDueMs shouldBe null
        }

        "a percept that goes back to the one that was let through is not held back" {
            val session = session(EVERY_100)
            session.perceive(listOf("dist(f,1)"), 0)
            session.perceive(listOf("dist(f,2)"), 50)
            session.perceive(listOf("dist(f,1)"), 60) shouldContainExactly listOf("dist(f,1)")
            session.nextDueMs shouldBe null
        }

        "numbered sensors in one message have a rate each, in their order" {
            val session = session(EVERY_100)
            session.perceive(listOf("dist(1,38)", "dist(2,90)"), 0) shouldContainExactly listOf("dist(1,38)", "dist(2,90)")
            session.perceive(listOf("dist(1,39)", "dist(2,91)"), 50) shouldContainExactly listOf("dist(1,38)", "dist(2,90)")
            session.explain("dist(2,91)", 50).toString() shouldContain "dist(2,90) stands for it"
            session.due(100)!! shouldContainExactly listOf("dist(1,39)", "dist(2,91)")
            session.perceive(listOf("dist(1,40)", "dist(2,92)"), 150) shouldContainExactly listOf("dist(1,39)", "dist(2,91)")
        }

        "conditions say which percepts it holds back" {
            val session = session("<filter everyMs='100'><predicate>dist</predicate><parameter id='0'>b</parameter></filter>")
            session.perceive(listOf("dist(f,1)", "dist(b,1)"), 0)
            session.perceive(listOf("dist(f,2)", "dist(b,2)"), 50) shouldContainExactly listOf("dist(f,2)", "dist(b,1)")
        }

        "another rule may drop the percept for good" {
            val session = session("$EVERY_100<filter><predicate>dist</predicate><parameter id='1' operator='GT'>10</parameter></filter>")
            session.perceive(listOf("dist(f,1)"), 0)
            session.perceive(listOf("dist(f,11)"), 50).shouldBeEmpty()
            session.nextDueMs shouldBe null
        }
    }

    "with a deadband" - {
        "what has moved less is held back, and what has moved as far is let through" {
            val session = session(WITHIN_5)
            session.perceive(listOf("dist(f,100)"), 0)
            session.perceive(listOf("dist(f,104.9)"), 10) shouldContainExactly listOf("dist(f,100)")
            session.perceive(listOf("dist(f,95.1)"), 20) shouldContainExactly listOf("dist(f,100)")
            session.perceive(listOf("dist(f,105)"), 30) shouldContainExactly listOf("dist(f,105)")
            session.perceive(listOf("dist(f,101)"), 40) shouldContainExactly listOf("dist(f,105)")
        }

        "what has settled is delivered in the end" {
            val session = session(WITHIN_5)
            session.perceive(listOf("dist(f,100)"), 0)
            session.perceive(listOf("dist(f,101)"), 5_000) shouldContainExactly listOf("dist(f,100)")
            session.perceive(listOf("dist(f,102)"), 5_500) shouldContainExactly listOf("dist(f,100)")
            session.nextDueMs shouldBe 6_000
            session.due(6_000)!! shouldContainExactly listOf("dist(f,102)")
        }

        "the time to settle begins anew when the number was back in between" {
            val session = session(WITHIN_5)
            session.perceive(listOf("dist(f,100)"), 0)
            session.perceive(listOf("dist(f,101)"), 100)
            session.perceive(listOf("dist(f,100)"), 200)
            session.perceive(listOf("dist(f,101)"), 300)
            session.nextDueMs shouldBe 1_300
        }

        "on a whole rule every number counts" {
            val session = session("<filter deadband='5'><predicate>pos</predicate></filter>")
            session.perceive(listOf("pos(0,0,a)"), 0)
            session.perceive(listOf("pos(4,-4,a)"), 1) shouldContainExactly listOf("pos(0,0,a)")
            session.perceive(listOf("pos(4,-5,a)"), 2) shouldContainExactly listOf("pos(4,-5,a)")
        }

        "an argument that is no number is not held back" {
            val session = session(WITHIN_5)
            session.perceive(listOf("dist(f,near)"), 0)
            session.perceive(listOf("dist(f,far)", "dist(f)"), 1) shouldContainExactly listOf("dist(f,far)", "dist(f)")
        }
    }

    "with both, small changes wait for the interval and large ones do not" {
        val session = session("<filter everyMs='100' deadband='5'><predicate>dist</predicate></filter>")
        session.perceive(listOf("dist(f,10)"), 0)
        session.perceive(listOf("dist(f,11)"), 10) shouldContainExactly listOf("dist(f,10)")
        session.perceive(listOf("dist(f,20)"), 20) shouldContainExactly listOf("dist(f,20)")
        session.perceive(listOf("dist(f,21)"), 119) shouldContainExactly listOf("dist(f,20)")
        session.due(120)!! shouldContainExactly listOf("dist(f,21)")
    }

    "a filter that keeps holds back too" {
        val session = session(EVERY_100, "keep='true'")
        session.perceive(listOf("dist(f,1)", "light(1)"), 0) shouldContainExactly listOf("dist(f,1)")
        session.perceive(listOf("dist(f,2)"), 50) shouldContainExactly listOf("dist(f,1)")
        session.due(100)!! shouldContainExactly listOf("dist(f,2)")
    }

    "whatever comes and whenever, the last value is delivered in the end" {
        checkAll(500, Arb.list(Arb.int(0..20), 1..12), Arb.list(Arb.int(0..150), 12..12), rates) { values, pauses, rate ->
            val session = Played(FilterSession.ofTexts())
            session.switchTo(PerceptionFilter("f", listOf(Rule(Predicate("dist"), rate = rate))))
            var now = 0L
            var believed = emptyList<String>()
            values.forEachIndexed { index, value ->
                believed = session.perceive(listOf("dist($value,$value,$value)"), now)
                now += pauses[index]
            }
            while (true) believed = session.due(session.nextDueMs ?: break)!!
            believed shouldBe listOf("dist(${values.last()},${values.last()},${values.last()})")
        }
    }

    "on a change of filter" - {
        val percepts = listOf("dist(f,1)", "dist(b,2)", "light(f,3)")
        val lightOnly = PerceptionFilter("lightOnly", Rule("dist"))

        "what the new one hides is forgotten" {
            val session = Played(FilterSession.ofTexts())
            session.perceive(percepts, 0)
            session.switchTo(lightOnly)
            session.perceive(percepts, 1) shouldContainExactly listOf("light(f,3)")
        }

        "it is frozen if the new one says so, until the next change" {
            val session = Played(FilterSession.ofTexts())
            session.perceive(percepts, 0)
            session.switchTo(PerceptionFilter("frozen", lightOnly.rules, onSwitch = PerceptionFilter.OnSwitch.FREEZE))
            session.perceive(listOf("dist(f,9)", "light(f,4)"), 1) shouldContainExactly listOf("light(f,4)", "dist(f,1)", "dist(b,2)")
            session.perceive(emptyList(), 2) shouldContainExactly listOf("dist(f,1)", "dist(b,2)")
            session.switchTo(null)
            session.perceive(listOf("light(f,5)"), 3) shouldContainExactly listOf("light(f,5)")
        }

        "a frozen percept gives way to one that differs from it in numbers only" {
            val session = Played(FilterSession.ofTexts())
            session.perceive(listOf("dist(f,227)", "dist(b,300)"), 0)
            val far = Rule("dist", Condition.Argument(1, TermTest.Compare(Operator.GT, GroundTerm.of("200"))))
            session.switchTo(PerceptionFilter("near", listOf(far), onSwitch = PerceptionFilter.OnSwitch.FREEZE))
            session.perceive(listOf("dist(f,228)", "dist(b,301)"), 1) shouldContainExactly listOf("dist(f,227)", "dist(b,300)")
            session.perceive(listOf("dist(f,150)", "dist(b,301)"), 2) shouldContainExactly listOf("dist(f,150)", "dist(b,300)")
        }

        "percepts of numbered sensors are frozen all" {
            val session = Played(FilterSession.ofTexts())
            session.perceive(listOf("dist(1,38)", "dist(2,90)"), 0)
            session.switchTo(PerceptionFilter("frozen", lightOnly.rules, onSwitch = PerceptionFilter.OnSwitch.FREEZE))
            session.perceive(listOf("light(f,4)"), 1) shouldContainExactly listOf("light(f,4)", "dist(1,38)", "dist(2,90)")
        }

        "what was held back is forgotten" {
            val session = session(EVERY_100)
            session.perceive(listOf("dist(f,1)"), 0)
            session.perceive(listOf("dist(f,2)"), 50)
            session.switchTo(session.filter)
            session.due(100) shouldBe null
            session.perceive(listOf("dist(f,3)"), 60) shouldContainExactly listOf("dist(f,3)")
        }
    }

    "percepts of more kinds than are remembered are let through" {
        val session = session(EVERY_100)
        val many = (0 until 10_000).map { "dist(s$it,1)" }
        session.perceive(many, 0) shouldBe many
        session.perceive(listOf("dist(s0,2)", "dist(s9999,2)"), 1) shouldContainExactly listOf("dist(s0,2)", "dist(s9999,1)")
    }

    "literals are filtered as texts are" {
        val literals = Played(literalSession())
        literals.switchTo(session(EVERY_100).filter)
        literals.perceive(listOf(ASSyntax.parseLiteral("dist(f,1)")), 0)
        literals.perceive(listOf(ASSyntax.parseLiteral("dist(f,-2)")), 50).map { "$it" } shouldContainExactly listOf("dist(f,1)")
        literals.due(100)!!.map { "$it" } shouldContainExactly listOf("dist(f,(-2))")
    }

    "what it was given and what it gave may be changed without changing what it remembers" {
        val session = session(EVERY_100)
        val given = mutableListOf("dist(f,1)", "light(1)")
        session.perceive(given, 0)
        given[0] = "dist(f,2)"
        session.perceive(given, 50)
        given.clear()
        session.due(100)!! shouldContainExactly listOf("dist(f,2)", "light(1)")
    }

    "it explains itself" {
        val session = session(EVERY_100)
        session.perceive(listOf("dist(f,1)"), 0)
        session.explain("dist(f,2)", 40).toString() shouldBe
            "dist(f,2) is held back for another 60 ms by filter test: it matches rule 1: " +
            "dist where the last one was less than 100 ms ago; dist(f,1) stands for it"
        session.explain("dist(b,2)", 40).toString() shouldContain "dist(b,2) is kept by filter test: rule 1 holds nothing back now"
        session.nextDueMs shouldBe null
        FilterSession.ofTexts().explain("a", 0).toString() shouldBe "a is kept: there is no filter"
    }
})
