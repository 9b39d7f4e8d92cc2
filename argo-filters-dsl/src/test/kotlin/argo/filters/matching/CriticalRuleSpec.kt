package argo.filters.matching

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.Deadband
import argo.filters.DropRules
import argo.filters.FilterException
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptType
import argo.filters.PerceptionFilter
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.TermTest
import argo.filters.dropFilter
import argo.filters.filters
import argo.filters.format.JsonFilters
import argo.filters.format.XmlFilters
import argo.filters.jason.perceptText
import argo.filters.lt
import argo.filters.matching.CriticalPercept
import argo.filters.perceptTexts
import argo.filters.reflex
import argo.filters.xml
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FreeSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.PropertyTesting
import io.kotest.property.checkAll
import jason.asSyntax.ASSyntax

private object Range : PerceptType("dist") {
    val side by atom()
    val cm by number()
}

class CriticalRuleSpec : FreeSpec({
    val near = Rule("dist", Condition.Argument(1, TermTest.Compare(Operator.LT, GroundTerm.Number(15.0))))
    val stop = CriticalRule(near, "stop")

    "it is one rule in all forms" {
        val expected = PerceptionFilter("f", listOf(Rule("light")), critical = listOf(stop, CriticalRule(Rule("bump"))))
        dropFilter("f") {
            critical("dist") { argument(1) lt 15; reflex("stop") }
            drop("light")
            critical("bump")
        } shouldBe expected
        dropFilter("f") {
            drop("light")
            critical(Range) { cm lt 15; reflex("stop") }
            critical("bump")
        } shouldBe expected
        xml("""
            <critical reflex="stop"><predicate>dist</predicate><parameter id="1" operator="LT">15</parameter></critical>
            <filter><predicate>light</predicate></filter>
            <critical><predicate>bump</predicate></critical>
        """) shouldBe expected
        JsonFilters.read("""
            {"critical": [{"predicate": "dist", "reflex": "stop", "conditions": [{"argument": 1, "operator": "LT", "value": 15}]},
                          {"predicate": "bump"}],
             "rules": [{"predicate": "light"}]}
        """, "f.json") shouldBe expected
        (PerceptionFilter("f", Rule("light")) == expected) shouldBe false
    }

    "its percepts pass whatever the other rules say" {
        val dropping = PerceptionFilter("d", listOf(Rule("dist"), Rule("light")), critical = listOf(stop)).matcher()
        dropping.drops("dist(f,14)") shouldBe false
        dropping.drops("dist(f,15)") shouldBe true
        dropping.drops(perceptText(ASSyntax.parseLiteral("dist(f,14)"))) shouldBe false
        dropping.drops("light(3)") shouldBe true
        val keeping = PerceptionFilter("k", listOf(Rule("light")), PerceptionFilter.Mode.KEEP, critical = listOf(stop)).matcher()
        listOf("dist(f,14)", "dist(f,15)", "light(3)", "temp(4)").filterNot(keeping::drops) shouldContainExactly
            listOf("dist(f,14)", "light(3)")
    }

    "a percept is critical as text and as literal alike, and then it is kept" {
        checkAll(2 * PropertyTesting.defaultIterationCount, filters, perceptTexts) { filter, text ->
            val matcher = filter.matcher()
            val rules = matcher.criticalRules(text)
            matcher.criticalRules(perceptText(ASSyntax.parseLiteral(text))) shouldBe rules
            if (rules.isNotEmpty()) matcher.drops(text) shouldBe false
        }
    }

    "a filter without critical rules does what it would without them" {
        checkAll(filters, perceptTexts) { filter, text ->
            val plain = PerceptionFilter(filter.name, filter.rules, filter.mode, filter.onSwitch).matcher()
            val matcher = filter.matcher()
            if (matcher.criticalRules(text).isEmpty()) matcher.drops(text) shouldBe plain.drops(text)
        }
    }

    "rates do not hold its percepts back, and hold back the others" {
        val session = Played(FilterSession.ofTexts())
        session.switchTo(
            PerceptionFilter("f", listOf(Rule(Predicate("dist"), rate = Rate(100, setOf(Deadband(1, 50.0))))), critical = listOf(stop)),
        )
        session.perceive(listOf("dist(f,30)"), 0) shouldContainExactly listOf("dist(f,30)")
        session.critical.shouldBeEmpty()
        session.perceive(listOf("dist(f,20)"), 10) shouldContainExactly listOf("dist(f,30)")
        session.perceive(listOf("dist(f,14)"), 20) shouldContainExactly listOf("dist(f,14)")
        session.critical shouldContainExactly listOf(CriticalPercept(stop, "dist(f,14)"))
        session.nextDueMs shouldBe null
        session.perceive(listOf("dist(f,13)"), 30) shouldContainExactly listOf("dist(f,13)")
        session.perceive(listOf("dist(f,20)"), 40) shouldContainExactly listOf("dist(f,13)")
        session.nextDueMs shouldBe 130
    }

    "a switch to its filter does not freeze its percepts, and a switch away forgets them" {
        val session = Played(FilterSession.ofTexts())
        session.perceive(listOf("dist(f,14)", "dist(b,90)"), 0)
        session.switchTo(PerceptionFilter("f", listOf(Rule("dist")), onSwitch = PerceptionFilter.OnSwitch.FREEZE, critical = listOf(stop)))
        session.perceive(listOf("dist(f,14)"), 1) shouldContainExactly listOf("dist(f,14)", "dist(b,90)")
        session.seen shouldContainExactly listOf("dist(f,14)")
        session.critical.map { it.percept } shouldContainExactly listOf("dist(f,14)")
        session.switchTo(null)
        session.perceive(listOf("dist(f,14)"), 2)
        session.critical.shouldBeEmpty()
    }

    "filters and explanations tell of it" {
        val filter = PerceptionFilter("f", listOf(Rule("dist")), critical = listOf(CriticalRule(Rule("bump")), stop))
        "$filter" shouldBe "filter f drops dist, treats as critical bump; dist where argument 1 is less than 15, with the reflex stop"
        filter.matcher().explain("dist(f,14)").toString() shouldBe
            "dist(f,14) is kept by filter f: it matches critical rule 2: dist where argument 1 is less than 15, with the reflex stop"
        filter.matcher().explain("dist(f,15)").outcome shouldBe Explanation.Outcome.DROPPED
    }

    "what makes no sense in Kotlin is refused" {
        fun refusal(rules: DropRules.() -> Unit) = shouldThrow<IllegalArgumentException> { dropFilter("f", rules = rules) }.message
        refusal { critical("dist") { everyMs(5) } } shouldContain "never held back"
        refusal { critical("dist") { argument(0) deadband 5 } } shouldContain "never held back"
        refusal { critical("dist") { reflex("") } } shouldContain "empty"
        refusal { critical("dist") { reflex(" stop") } } shouldContain "blank"
        refusal { critical("dist") { reflex("x".repeat(256)) } } shouldContain "at most 255"
        refusal { critical("dist") { reflex("€") } } shouldContain "U+20AC"
        refusal { critical("dist") { reflex("say(fffe05front)") } } shouldContain "'fffe05'"
        refusal { critical("dist") { reflex("a\nb") } } shouldContain "U+000A"
        refusal { critical("dist") { reflex("getPercepts") } } shouldContain "a board takes getPercepts for the request for percepts"
        refusal { critical("dist") { reflex("getPercepts(a)") } } shouldContain "a board takes getPercepts(a) for the request for percepts"
        dropFilter("f") { critical("dist") { reflex("getPerceptsLater") } }
        refusal { critical("dist") { reflex("stop"); reflex("back") } } shouldContain "has the reflex 'stop' already"
        refusal { critical("dist") { argument(1) } } shouldContain "there is no condition on argument(1)"
    }

    "a file is refused where" - {
        val xmlRefusals = mapOf(
            "<critical ¦reflex=''><predicate>d</predicate></critical>" to "the reflex '' is empty",
            "<critical ¦reflex='€'><predicate>d</predicate></critical>" to "U+20AC",
            "<critical ¦reflex='say(fffe05front)'><predicate>d</predicate></critical>" to "'fffe05'",
            "<critical ¦reflex='getPercepts'><predicate>d</predicate></critical>" to
                "a board takes getPercepts for the request for percepts, which argo.percepts(open) sends, and not for a command",
            "<critical ¦everyMs='5'><predicate>d</predicate></critical>" to
                "the attribute 'everyMs' on <critical>; expected arity or reflex or smoothed",
            "<critical ¦deadband='5'><predicate>d</predicate></critical>" to "the attribute 'deadband' on <critical>",
            "<critical><predicate>d</predicate><parameter id='1' ¦deadband='5'/></critical>" to "never held back",
            "<filter ¦reflex='stop'><predicate>d</predicate></filter>" to "the attribute 'reflex' on <filter>",
            "¦<critical/>" to "the rule has no predicate",
            "<critical>¦stop<predicate>d</predicate></critical>" to "the text 'stop'",
            "<critical><predicate>d</predicate><parameter id='0' operator='LT'>¦near</parameter></critical>" to "compares numbers",
        )
        xmlRefusals.forEach { (marked, words) ->
            marked {
                val before = "<PerceptionFilter>\n  " + marked.substringBefore('¦')
                val text = "<PerceptionFilter>\n  ${marked.replace("¦", "")}\n</PerceptionFilter>"
                val problems = shouldThrow<FilterException> { XmlFilters.read(text, "f.xml") }.problems
                withClue(problems) {
                    problems shouldHaveSize 1
                    problems.single().message shouldContain words
                    (problems.single().line to problems.single().column) shouldBe (2 to before.substringAfterLast('\n').length + 1)
                }
            }
        }
        val jsonRefusals = mapOf(
            """{"predicate": "d", "reflex": ¦""}""" to "the reflex '' is empty",
            """{"predicate": "d", "reflex": ¦"getPercepts(a)"}""" to
                "a board takes getPercepts(a) for the request for percepts, which argo.percepts(open) sends, and not for a command",
            """{"predicate": "d", "reflex": ¦5}""" to "\"reflex\" is 5; expected text",
            """{"predicate": "d", ¦"everyMs": 5}""" to "\"everyMs\" in a critical rule",
            """{"predicate": "d", "conditions": [{"argument": 0, ¦"deadband": 5}]}""" to "never held back",
            """¦{"reflex": "stop"}""" to "the rule has no \"predicate\"",
            """¦"dist"""" to "a critical rule is expected",
        )
        jsonRefusals.forEach { (marked, words) ->
            marked {
                val before = "{\"rules\": [], \"critical\": [\n  " + marked.substringBefore('¦')
                val text = "{\"rules\": [], \"critical\": [\n  ${marked.replace("¦", "")}\n]}"
                val problems = shouldThrow<FilterException> { JsonFilters.read(text, "f.json") }.problems
                withClue(problems) {
                    problems shouldHaveSize 1
                    problems.single().message shouldContain words
                    (problems.single().line to problems.single().column) shouldBe (2 to before.substringAfterLast('\n').length + 1)
                }
            }
        }
    }
})
