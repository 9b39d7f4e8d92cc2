package argo.filters.matching

import argo.filters.DropRules
import argo.filters.PerceptType
import argo.filters.PerceptionFilter
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.dropFilter
import argo.filters.format.JsonFilters
import argo.filters.keepFilter
import argo.filters.lt
import argo.filters.xml
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FreeSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

private object Near : PerceptType("dist") {
    val side by atom()
    val cm by number()
}

private val near = keepFilter("near") { keep("dist") { argument(1) lt 40 until 45 } }

private fun session(filter: PerceptionFilter) = Played(FilterSession.ofTexts()).also { it.switchTo(filter) }

/** Returns, for each of a sensor's [numbers], whether [filter] lets its percept through. */
private fun kept(filter: PerceptionFilter, numbers: List<Number>): List<Boolean> = session(filter).let { session ->
    numbers.mapIndexed { at, number -> session.perceive(listOf("dist(f,$number)"), at * 50L).isNotEmpty() }
}

class SecondLimitSpec : FreeSpec({
    "it is one condition in all forms" {
        keepFilter("f") { keep(Near) { cm lt 40 until 45 } } shouldBe near
        xml("<filter><predicate>dist</predicate><parameter id='1' operator='LT' until='45'>40</parameter></filter>").rules shouldBe
            near.rules
        JsonFilters.read(
            """
            {"keep": true, "rules": [{"predicate": "dist", "conditions": [{"argument": 1, "operator": "LT", "value": 40, "until": 45}]}]}
            """,
            "f.json",
        ) shouldBe near
        "$near" shouldBe "filter near keeps only dist where argument 1 is less than 40 until 45"
    }

    "each ordering holds from its limit until the second one" {
        val numbers = listOf(45, 40, 39, 40, 44, 45, 44, 39, 46)
        kept(near, numbers) shouldBe listOf(false, false, true, true, true, false, false, true, false)
        kept(keepFilter("f") { keep("dist") { argument(1) le 40 until 45 } }, numbers) shouldBe
            listOf(false, true, true, true, true, true, true, true, false)
        kept(keepFilter("f") { keep("dist") { argument(1) gt 44 until 40 } }, numbers) shouldBe
            listOf(true, false, false, false, false, true, true, false, true)
        kept(keepFilter("f") { keep("dist") { argument(1) ge 44 until 40 } }, numbers) shouldBe
            listOf(true, true, false, false, true, true, true, false, true)
    }

    "it never chatters: it changes only when the number has crossed the whole band" {
        checkAll(500, Arb.list(Arb.int(30..55), 1..60)) { numbers ->
            var isOn = false
            kept(near, numbers) shouldBe numbers.map { number -> (number < if (isOn) 45 else 40).also { isOn = it } }
        }
        checkAll(100, Arb.list(Arb.int(41..44), 1..60)) { noise ->
            kept(near, listOf(39) + noise).distinct() shouldBe listOf(true)
            kept(near, listOf(46) + noise).distinct() shouldBe listOf(false)
        }
    }

    "each sensor counts by itself, and a percept without the number ends it" {
        val session = session(near)
        session.perceive(listOf("dist(1,39)", "dist(2,43)", "dist(b,44)"), 0) shouldContainExactly listOf("dist(1,39)")
        session.perceive(listOf("dist(1,43)", "dist(2,39)", "dist(b,43)"), 50) shouldContainExactly listOf("dist(1,43)", "dist(2,39)")
        session.perceive(listOf("dist(1,far)", "dist(2,44)"), 100) shouldContainExactly listOf("dist(2,44)")
        session.perceive(listOf("dist(1,43)", "dist(2)"), 150).shouldBeEmpty()
    }

    "a message without the sensor ends it" {
        val session = session(near)
        session.perceive(listOf("dist(f,39)", "dist(b,39)"), 0)
        session.perceive(listOf("dist(b,43)"), 50) shouldContainExactly listOf("dist(b,43)")
        session.perceive(listOf("dist(f,43)", "dist(b,43)"), 100) shouldContainExactly listOf("dist(b,43)")
    }

    "a sensor that a message names several times goes on with each number for which it held in the message before, in any order" {
        checkAll(300, Arb.list(Arb.list(Arb.int(35..50), 1..3), 1..20)) { messages ->
            val session = session(near)
            var held = false
            messages.forEachIndexed { at, numbers ->
                val expected = numbers.filter { it < if (held) 45 else 40 }
                session.perceive(numbers.map { "dist(f,$it)" }, at * 50L) shouldBe expected.map { "dist(f,$it)" }
                held = expected.isNotEmpty()
            }
        }
    }

    "it holds whatever other conditions and rules decide" {
        val session = session(
            dropFilter("f") {
                drop("dist") { argument(1) gt 200 }
                drop("dist") { argument(2) eq "fast"; argument(1) gt 100 until 80 }
                drop("dist") { argument(1) gt 90 until 70; argument(2) gt 5 until 2 }
            },
        )
        session.perceive(listOf("dist(f,250,fast)", "dist(b,250,6)"), 0).shouldBeEmpty()
        session.perceive(listOf("dist(f,85,fast)", "dist(f,85,slow)", "dist(b,75,6)"), 50) shouldContainExactly listOf("dist(f,85,slow)")
        session.perceive(listOf("dist(b,72,6)"), 100).shouldBeEmpty()
    }

    "a question about what is held back changes nothing" {
        val session = session(dropFilter("f") { drop("dist") { argument(1) gt 100 until 90 }; drop("temp") { everyMs(100) } })
        session.perceive(listOf("dist(f,101)", "temp(1)"), 0)
        session.perceive(listOf("dist(f,95)", "temp(2)"), 50) shouldContainExactly listOf("temp(1)")
        session.due(100)!! shouldContainExactly listOf("temp(2)")
        session.perceive(listOf("dist(f,95)"), 150).shouldBeEmpty()
        session.perceive(listOf("dist(f,85)"), 200) shouldContainExactly listOf("dist(f,85)")
        session.explain("dist(f,105)", 210).outcome shouldBe Explanation.Outcome.DROPPED
        session.perceive(listOf("dist(f,95)"), 250) shouldContainExactly listOf("dist(f,95)")
    }

    "a stray number that only a critical rule takes as it came is not noted by rules that look at the percept that stands" {
        val filter = dropFilter("f") {
            smooth("dist") { argument(1) median 3 }
            critical("dist") { argument(1) lt 10; reflex("stop") }
            critical("dist") { argument(1) lt 20 until 60; smoothed(); reflex("slow") }
            drop("dist") { argument(1) lt 30 until 60 }
        }
        val rated = Rule(Predicate("temp"), rate = Rate(9))
        for (rules in listOf(filter.rules, filter.rules + rated)) {
            val session = session(PerceptionFilter("g", rules, critical = filter.critical, smoothing = filter.smoothing))
            listOf(50, 50).forEachIndexed { at, cm -> session.perceive(listOf("dist(f,$cm)"), at * 50L) }
            session.perceive(listOf("dist(f,5)"), 100) shouldContainExactly listOf("dist(f,5)")
            session.critical.map { it.rule.reflex } shouldContainExactly listOf("stop")
            session.perceive(listOf("dist(f,50)"), 150) shouldContainExactly listOf("dist(f,50)")
            session.critical.shouldBeEmpty()
        }
    }

    "percepts too long to be remembered have the first limit only" {
        val session = session(near)
        fun percept(cm: Int) = "dist(${"x".repeat(1_100)},$cm)"
        session.perceive(listOf(percept(39)), 0) shouldContainExactly listOf(percept(39))
        session.perceive(listOf(percept(43)), 50).shouldBeEmpty()
    }

    "the same percepts twice are decided over as once" {
        checkAll(100, Arb.list(Arb.int(30..55), 1..30)) { numbers ->
            kept(near, numbers.flatMap { listOf(it, it) }).filterIndexed { at, _ -> at % 2 == 1 } shouldBe kept(near, numbers)
        }
    }

    "a critical rule stays met until it" {
        val session = session(dropFilter("f") { critical("dist") { argument(1) lt 15 until 20; reflex("stop") }; drop("dist") })
        val met = listOf(16, 14, 19, 20, 19).mapIndexed { at, cm ->
            session.perceive(listOf("dist(f,$cm)"), at * 50L).size to session.critical.size
        }
        met shouldBe listOf(0 to 0, 1 to 1, 1 to 1, 0 to 0, 0 to 0)
    }

    "a critical rule that the next filter has too stays met until it, and no other rule does" {
        fun filter(name: String) = dropFilter(name) {
            critical("dist") { argument(1) lt 15 until 20; reflex("stop") }
            drop("temp") { argument(0) gt 30 until 20 }
        }
        val session = session(filter("f"))
        session.perceive(listOf("dist(f,14)", "temp(31)"), 0) shouldContainExactly listOf("dist(f,14)")
        session.switchTo(filter("g"))
        session.perceive(listOf("dist(f,19)", "temp(25)"), 50) shouldContainExactly listOf("dist(f,19)", "temp(25)")
        session.critical.size shouldBe 1
        session.switchTo(dropFilter("h") { critical("dist") { argument(1) lt 15 until 25; reflex("stop") } })
        session.perceive(listOf("dist(f,19)"), 100)
        session.critical.size shouldBe 0
    }

    "with a rate, it decides which percepts are held back" {
        val session = session(dropFilter("f") { drop("dist") { argument(1) gt 100 until 90; everyMs(1_000) } })
        session.perceive(listOf("dist(f,101)"), 0)
        session.perceive(listOf("dist(f,95)"), 50) shouldContainExactly listOf("dist(f,101)")
        session.perceive(listOf("dist(f,89)"), 100) shouldContainExactly listOf("dist(f,89)")
    }

    "it decides over the percept that stands" {
        val session = session(dropFilter("f") { smooth("dist") { argument(1) median 3 }; drop("dist") { argument(1) gt 100 until 90 } })
        listOf(50, 51, 400, 52).forEachIndexed { at, cm -> session.perceive(listOf("dist(f,$cm)"), at * 50L) }
        session.perceive(listOf("dist(f,95)"), 200) shouldContainExactly listOf("dist(f,95)")
    }

    "it is explained, and forgotten with the rest" {
        val session = FilterSession.ofTexts().also { it.switchTo(near) }
        session.explain("dist(f,43)", 0).toString() shouldContain "it does not match rule 1: argument 1 is 43, not less than 40"
        session.perceive(listOf("dist(f,39)"), 0)
        session.explain("dist(f,43)", 50).toString() shouldContain "kept by filter near: it matches rule 1"
        session.explain("dist(b,43)", 50).toString() shouldContain "is dropped"
        session.forget()
        session.perceive(listOf("dist(f,43)"), 50).kept.shouldBeEmpty()
        near.matcher().drops("dist(f,43)") shouldBe true
    }

    "a limit that is not beyond the first one is refused" {
        fun refusal(rules: DropRules.() -> Any) = shouldThrow<IllegalArgumentException> { dropFilter("x") { rules() } }.message
        refusal { drop("d") { argument(1) lt 40 until 40 } } shouldContain
            "the condition holds until 40 though it is less than 40; expected a number above that"
        refusal { drop("d") { argument(1) gt 40 until 41 } } shouldContain "expected a number below that"
        refusal { drop("d") { (argument(1) lt 40).let { it until 45; it until 50 } } } shouldContain
            "the condition 'argument 1 is less than 40 until 45' has a second limit already; expected no other one, and not 50"
        refusal { drop("d") { argument(1) gt 40 until Double.NEGATIVE_INFINITY } } shouldContain "no finite number"
    }
})
