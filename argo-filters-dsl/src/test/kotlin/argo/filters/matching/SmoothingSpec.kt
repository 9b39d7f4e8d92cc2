package argo.filters.matching

import argo.filters.CriticalRule
import argo.filters.DropRules
import argo.filters.GroundTerm
import argo.filters.Outliers
import argo.filters.PerceptType
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.SmoothingRule
import argo.filters.annotate
import argo.filters.dropFilter
import argo.filters.eq
import argo.filters.format.JsonFilters
import argo.filters.jason.literalSession
import argo.filters.keepFilter
import argo.filters.maxRate
import argo.filters.median
import argo.filters.outliers
import argo.filters.xml
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FreeSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.longs.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import jason.asSyntax.ASSyntax
import java.lang.management.ManagementFactory

private object Reading : PerceptType("dist") {
    val side by atom()
    val cm by number()
}

private fun session(filter: PerceptionFilter): Played<String> = Played(FilterSession.ofTexts()).also { it.switchTo(filter) }

private fun smoothed(filter: PerceptionFilter, numbers: List<Number>, pauseMs: Long = 50): List<Double> {
    val session = session(filter)
    return numbers.mapIndexed { at, number ->
        session.perceive(listOf("dist(f,${GroundTerm.Number(number.toDouble())})"), at * pauseMs).single()
            .substringAfter(',').substringBefore(')').toDouble()
    }
}

private val median5 = dropFilter("f") { smooth("dist") { argument(1) median 5 } }
private val outliers5 = dropFilter("f") { smooth("dist") { argument(1).outliers(3) } }

class SmoothingSpec : FreeSpec({
    "a smoothing rule is one rule in all forms" {
        val expected = PerceptionFilter(
            "f", emptyList(),
            smoothing = listOf(
                SmoothingRule(dropFilter("r") { drop("dist") { argument(0) eq "f" } }.rules.single(), 1, 200.0, Outliers(3.0, 7), 5, true),
            ),
        )
        dropFilter("f") {
            smooth("dist") {
                argument(0) eq "f"
                argument(1) maxRate 200
                argument(1).outliers(3, among = 7)
                argument(1) median 5
                annotate()
            }
        } shouldBe expected
        dropFilter("f") {
            smooth(Reading) {
                side eq "f"
                cm maxRate 200
                cm.outliers(3, among = 7)
                cm median 5
                annotate()
            }
        } shouldBe expected
        xml("""
            <smooth annotate="true">
              <predicate>dist</predicate>
              <parameter id="0">f</parameter>
              <parameter id="1" maxRate="200" outliers="3" among="7" median="5"/>
            </smooth>
        """) shouldBe expected
        JsonFilters.read("""
            {"rules": [], "smooth": [{"predicate": "dist", "annotate": true, "conditions": [
              {"argument": 0, "value": "f"}, {"argument": 1, "maxRate": 200, "outliers": 3, "among": 7, "median": 5}]}]}
        """, "f.json") shouldBe expected
        xml("<smooth><predicate>dist</predicate><parameter id='1' outliers='3'/></smooth>").smoothing.single().outliers shouldBe
            Outliers(3.0, 5)
    }

    "with a median" - {
        "the percept in the middle of the last ones stands, as the board wrote it" {
            val session = session(dropFilter("f") { smooth("dist") { argument(1) median 3 } })
            session.perceive(listOf("dist(f, 40.0)[q(1)]", "light(3)"), 0) shouldContainExactly listOf("dist(f, 40.0)[q(1)]", "light(3)")
            session.perceive(listOf("dist(f, 300)", "light(4)"), 50) shouldContainExactly listOf("dist(f, 300)", "light(4)")
            session.perceive(listOf("dist(f, 42)", "light(5)"), 100) shouldContainExactly listOf("dist(f, 42)", "light(5)")
            session.perceive(listOf("dist(f, 0)", "light(6)"), 150) shouldContainExactly listOf("dist(f, 42)", "light(6)")
            session.seen shouldContainExactly listOf("dist(f, 42)", "light(6)")
        }

        "it equals the naive one, whatever comes" {
            checkAll(300, Arb.list(Arb.int(0..50), 1..40), Arb.element(3, 5, 9)) { numbers, size ->
                smoothed(dropFilter("f") { smooth("dist") { argument(1) median size } }, numbers).drop(size - 1) shouldBe
                    numbers.windowed(size) { it.sorted()[size / 2].toDouble() }
            }
        }

        "a step is believed after half of the window" {
            smoothed(median5, listOf(90, 90, 90, 90, 90, 20, 20, 20)) shouldBe listOf(90, 90, 90, 90, 90, 90, 90, 20).map(Int::toDouble)
        }

        "once smoothed is smooth: a median of what does not change changes nothing" {
            checkAll(100, Arb.list(Arb.int(0..20), 1..30)) { numbers ->
                val steady = List(12) { numbers.last() }
                smoothed(median5, numbers + steady).takeLast(9).distinct() shouldBe listOf(numbers.last().toDouble())
            }
        }

        "all beside its argument names a sensor, numbers too" {
            val session = session(median5)
            for (at in 0 until 5) session.perceive(listOf("dist(1,10)", "dist(2,90)", "dist(a,b,7)", "dist(x)", "dist(f,near)"), at * 50L)
            session.perceive(listOf("dist(1,80)", "dist(2,20)", "dist(a,b,8)", "dist(x)", "dist(f,far)"), 300) shouldContainExactly
                listOf("dist(1,10)", "dist(2,90)", "dist(a,b,8)", "dist(x)", "dist(f,far)")
        }

        "numbers are those of Jason, and one without end stands for itself" {
            val session = session(median5)
            for (at in 0 until 5) session.perceive(listOf("dist(f,-4e1)"), at * 50L)
            session.perceive(listOf("dist(f,(-9))"), 300) shouldContainExactly listOf("dist(f,-4e1)")
            session.perceive(listOf("dist(f,1e999)"), 350) shouldContainExactly listOf("dist(f,1e999)")
        }
    }

    "with outliers" - {
        "the last credible percept stands for one that is far from most, and does not count as seen" {
            val session = session(outliers5)
            listOf(40, 41, 39, 40).forEachIndexed { at, cm -> session.perceive(listOf("dist(f,$cm)"), at * 50L) }
            session.perceive(listOf("dist(f,300)", "light(1)"), 200) shouldContainExactly listOf("dist(f,40)", "light(1)")
            session.seen shouldContainExactly listOf("light(1)")
            session.perceive(listOf("dist(f,42)"), 250) shouldContainExactly listOf("dist(f,42)")
        }

        "a sensor that stood still may move by a few units of its last digit" {
            smoothed(outliers5, listOf(40, 40, 40, 40, 40, 42)).last() shouldBe 42.0
            smoothed(outliers5, listOf(4.00, 4.00, 4.00, 4.00, 4.00, 4.42)).last() shouldBe 4.0
            smoothed(outliers5, listOf(5.0E-4, 5.0E-4, 5.0E-4, 5.2E-4)).last() shouldBe 5.2E-4
            smoothed(outliers5, listOf(5.0E-4, 5.0E-4, 5.0E-4, 5.4E-4)).last() shouldBe 5.0E-4
        }

        "of the first two percepts neither is an outlier" {
            smoothed(outliers5, listOf(300, 40, 41, 42, 300)) shouldBe listOf(300.0, 40.0, 41.0, 42.0, 42.0)
        }

        "each step is believed once more than half of the window is behind it, whatever the noise" {
            checkAll(500, Arb.list(Arb.int(80..90), 5..9), Arb.list(Arb.int(20..30), 9..9), Arb.element(3, 5, 7)) { before, after, among ->
                val filter = dropFilter("f") { smooth("dist") { argument(1).outliers(1, among) } }
                smoothed(filter, before + after)[before.size + among / 2] shouldBe after[among / 2].toDouble()
            }
        }
    }

    "with a greatest rate" - {
        val filter = dropFilter("f") { smooth("dist") { argument(1) maxRate 100 } }

        "the last credible percept stands for one that the sensor cannot have reached" {
            smoothed(filter, listOf(40, 45, 51, 50, 300, 52)) shouldBe listOf(40.0, 45.0, 45.0, 50.0, 50.0, 52.0)
        }

        "the third in a row that can follow each other is believed" {
            smoothed(filter, listOf(300, 40, 41, 42, 43)) shouldBe listOf(300.0, 300.0, 300.0, 42.0, 43.0)
            smoothed(filter, listOf(40, 300, 0, 300, 0, 300)).distinct() shouldBe listOf(40.0)
        }
    }

    "what is too fast is no outlier, and what is one is in no median" {
        val filter = dropFilter("f") { smooth("dist") { argument(1) maxRate 1_000; argument(1).outliers(3); argument(1) median 3 } }
        smoothed(filter, listOf(40, 40, 40, 40, 400, 60, 40, 44)) shouldBe listOf(40, 40, 40, 40, 40, 40, 40, 40).map(Int::toDouble)
    }

    "the filter's rules decide over the percept that stands" {
        val far = dropFilter("f") { smooth("dist") { argument(1) median 3 }; drop("dist") { argument(1) gt 100 } }
        val session = session(far)
        session.perceive(listOf("dist(f,40)"), 0)
        session.perceive(listOf("dist(f,41)"), 50)
        session.perceive(listOf("dist(f,300)"), 100) shouldContainExactly listOf("dist(f,41)")
        session.perceive(listOf("dist(f,301)"), 150).shouldBeEmpty()
        val near = session(keepFilter("f") { smooth("dist") { argument(1) median 3 }; keep("dist") { argument(1) lt 100; everyMs(60) } })
        for (at in 0 until 3) near.perceive(listOf("dist(f,4$at)", "light(1)"), at * 50L)
        near.perceive(listOf("dist(f,300)"), 150) shouldContainExactly listOf("dist(f,41)")
    }

    "a critical rule" - {
        fun PerceptionFilter.met(numbers: List<Int>): List<Pair<String, List<String>>> = session(this).let { session ->
            numbers.mapIndexed { at, cm ->
                session.perceive(listOf("dist(f,$cm)"), at * 50L).single() to session.critical.map { it.percept }
            }
        }

        "decides over the percept as it came, which then stands for itself" {
            val raw = dropFilter("f") { smooth("dist") { argument(1) median 3 }; critical("dist") { argument(1) lt 15; reflex("stop") } }
            raw.met(listOf(40, 41, 5, 42)) shouldContainExactly listOf(
                "dist(f,40)" to emptyList(), "dist(f,41)" to emptyList(), "dist(f,5)" to listOf("dist(f,5)"), "dist(f,41)" to emptyList(),
            )
        }

        "decides over the percept that stands, if it says so" {
            val smoothed = dropFilter("f") {
                smooth("dist") { argument(1) median 3 }
                critical("dist") { argument(1) lt 15; smoothed(); reflex("stop") }
                drop("dist") { argument(1) lt 20 }
            }
            smoothed.critical.single() shouldBe CriticalRule(smoothed.critical.single().rule, "stop", true)
            smoothed.met(listOf(40, 41, 5, 6)) shouldContainExactly listOf(
                "dist(f,40)" to emptyList(), "dist(f,41)" to emptyList(), "dist(f,40)" to emptyList(), "dist(f,6)" to listOf("dist(f,6)"),
            )
        }
    }

    "asked for, percepts that stand have an annotation" - {
        val filter = dropFilter("f") { smooth("dist") { argument(1) median 3; annotate() } }

        "as texts" {
            val session = session(filter)
            session.perceive(listOf("dist(f,1)", "dist(b,1)[q(1)]", "dist(l,1)[ ]", "light(1)"), 0) shouldContainExactly
                listOf("dist(f,1)[smoothed]", "dist(b,1)[q(1),smoothed]", "dist(l,1)[smoothed]", "light(1)")
            session.perceive(listOf("dist(f,1)[smoothed]"), 50) shouldContainExactly listOf("dist(f,1)[smoothed]")
        }

        "as literals" {
            val session = Played(literalSession())
            session.switchTo(filter)
            val percept = ASSyntax.parseLiteral("dist(f,1)[q(1)]")
            session.perceive(listOf(percept), 0).map { "$it" } shouldContainExactly listOf("dist(f,1)[q(1),smoothed]")
            "$percept" shouldBe "dist(f,1)[q(1)]"
        }
    }

    "percepts that are old count once" {
        val session = FilterSession.ofTexts().also { it.switchTo(median5) }
        session.perceive(listOf("dist(f,40)", "dist(b,40)"), 0)
        repeat(9) { session.perceive(listOf("dist(f,300)", "dist(b,300)"), it + 1L, if (it > 0) setOf("dist(f,300)") else emptySet()) }
        session.perceive(listOf("dist(f,41)", "dist(b,41)"), 20)
        session.perceive(listOf("dist(f,42)", "dist(b,42)"), 21).kept shouldContainExactly listOf("dist(f,42)", "dist(b,300)")
    }

    "what was before is forgotten on demand and at a change of the filter" {
        for (end in listOf<FilterSession<String>.() -> Unit>({ forget() }, { switchTo(filter) })) {
            val session = FilterSession.ofTexts().also { it.switchTo(median5) }
            repeat(5) { session.perceive(listOf("dist(f,40)"), it.toLong()) }
            session.end()
            session.perceive(listOf("dist(f,9)"), 9).kept shouldContainExactly listOf("dist(f,9)")
        }
    }

    "sensors that came longest ago are forgotten if there are too many" {
        val session = session(median5)
        repeat(5) { session.perceive(listOf("dist(s0,1)"), it.toLong()) }
        session.perceive((1..5_000).map { "dist(s$it,1)" }, 5)
        session.perceive(listOf("dist(s5000,1)"), 6)
        session.perceive(listOf("dist(s0,9)", "dist(s5000,9)"), 7) shouldContainExactly listOf("dist(s0,9)", "dist(s5000,1)")
        val long = "dist(${"x".repeat(1_100)},9)"
        session.perceive(listOf(long), 10) shouldContainExactly listOf(long)
    }

    "a sensor that was forgotten and came again has one history, wherever in a message it comes" {
        val session = session(median5)
        repeat(5) { session.perceive(listOf("dist(s0,1)"), it.toLong()) }
        session.perceive(listOf("light(1)") + (1..5_000).map { "dist(s$it,1)" }, 5)
        repeat(2) { session.perceive(listOf("light(1)", "dist(s0,9)"), 6L + it) }
        session.perceive(listOf("dist(s0,9)"), 8) shouldContainExactly listOf("dist(s0,9)")
        repeat(3) { session.perceive(listOf("dist(s0,5)"), 9L + it) }
        session.perceive(listOf("light(1)", "dist(s0,9)"), 12) shouldContainExactly listOf("light(1)", "dist(s0,5)")
    }

    "it explains itself, and changes nothing by that" {
        val filter = dropFilter("f") { smooth("dist") { argument(1) maxRate 5_000; argument(1).outliers(3); argument(1) median 3 } }
        val session = session(filter)
        listOf(40, 41, 39, 40).forEachIndexed { at, cm -> session.perceive(listOf("dist(f,$cm)"), at * 50L) }
        val rule = "by filter f: by smoothing rule 1 (dist, by a change of at most 5000 a second, leaving out outliers of 3 deviations " +
            "among the last 5, the median of the last 3 of argument 1)"
        val kept = "is kept by filter f: it has no rule on dist with 2 arguments"
        repeat(3) {
            "${session.explain("dist(f,200)", 200)}" shouldBe
                "dist(f,200) is replaced $rule 200 is an outlier, since the median of the last 5 is 40; dist(f,40) $kept"
        }
        "${session.explain("dist(f,900)", 200)}" shouldBe
            "dist(f,900) is replaced $rule 40 cannot have become 900 so fast; dist(f,40) $kept"
        "${session.explain("dist(f,42)", 200)}" shouldBe "dist(f,42) is replaced $rule the median of the last 3 is 40; dist(f,40) $kept"
        session.explain("dist(b,42)", 200).toString() shouldBe "dist(b,42) $kept"
        "${filter.matcher().explain("dist(f,40)")}" shouldContain "; by smoothing rule 1 (dist, by"
        "$filter" shouldContain ", smooths dist, by a change of at most 5000 a second"
    }

    "a sensor that is known costs no memory" {
        val filter = dropFilter("f") { smooth("dist") { argument(1).outliers(3); argument(1) median 5 } }
        val smoother = Smoother(filter.matcher(), { it: String -> it }, { it })
        val messages = List(25) { at -> List(4) { "dist(s$it,${(at * 4 + it) * 7 % 11}${if (at % 9 == 0) 0 else ""})" } }
        fun run() {
            messages.forEach { smoother.picture(it, 0, emptySet()) }
        }
        repeat(200) { run() } // until the code is compiled
        val threads = ManagementFactory.getThreadMXBean() as com.sun.management.ThreadMXBean
        val before = threads.currentThreadAllocatedBytes
        repeat(100) { run() }
        threads.currentThreadAllocatedBytes - before shouldBeLessThan 10_000 // one byte a percept would exceed this
    }

    "refused is" - {
        fun refusal(rules: DropRules.() -> Unit) = shouldThrow<IllegalArgumentException> { dropFilter("x", rules = rules) }.message

        "a rule that smooths nothing, two arguments, or one twice" {
            refusal { smooth("dist") { argument(0) eq "f" } } shouldContain "smooths nothing"
            refusal { smooth("dist") { argument(1) median 3; argument(2) median 3 } } shouldContain "smooths argument 1 already"
            refusal { smooth("dist") { argument(1) median 3; argument(1) median 5 } } shouldContain "the median of 3 already"
            refusal { smooth("dist") { argument(1) } } shouldContain "no condition on argument(1)"
        }

        "a number without a meaning" {
            refusal { smooth("dist") { argument(1) median 4 } } shouldContain "an odd number of percepts from 3 to 99"
            refusal { smooth("dist") { argument(1) median 101 } } shouldContain "an odd number"
            refusal { smooth("dist") { argument(1) maxRate 0 } } shouldContain "above 0"
            refusal { smooth("dist") { argument(1).outliers(0.5) } } shouldContain "ordinary percepts"
            refusal { smooth("dist") { argument(1).outliers(3, among = 2) } } shouldContain "an odd number"
        }

        "a rate or a second limit in a smoothing rule" {
            refusal { smooth("dist") { argument(1) median 3; everyMs(5) } } shouldContain "delays no percepts"
            refusal { smooth("dist") { argument(1) median 3; argument(2) lt 3 until 4 } } shouldContain "one limit"
        }
    }
})
