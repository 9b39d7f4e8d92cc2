package javino.sim

import argo.acting.boardRuleOf
import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.TermTest
import argo.filters.matching.FilterSession
import argo.filters.matching.matcher
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import javino.PerceptTerm

/** Checks that a board decides like a filter for every mapped rule. In this package the test sees how the simulated board decides. */
class BoardRuleMappingSpec : FunSpec({
    val words = Arb.element("front", "back", "f", "'a b'", "true", "x1")
    val numbers = arbitrary { rs ->
        val digits = listOf("0", "00", "7", "14", "15", "15.0", "15.00", "0015", "15.5", "123456789012.125", "0.1", "14.999999999999")
        Arb.element("", "", "-", "+").bind() + Arb.element(digits).bind()
    }
    val others = Arb.element("\"front\"", "\"a,b)\"", "pos(15,front)", "[1,2]", "f(\"(\")", "\"\"")
    val blanks = Arb.element("", "", "", " ", "  ")

    val arguments = arbitrary { blanks.bind() + Arb.element(words, words, numbers, numbers, others).bind().bind() + blanks.bind() }
    val percepts = arbitrary {
        val functor = Arb.element("dist", "dist", "dist", "distance", "~dist", "d").bind()
        val given = Arb.list(arguments, 0..4).bind()
        val annotations = Arb.element("", "", "", "[q(15)]", "[a,b(\"]\")]").bind()
        functor + (if (given.isEmpty()) "" else given.joinToString(",", "(", ")")) + annotations
    }
    val conditions = arbitrary {
        val operator = Arb.element(Operator.entries).bind()
        val isWord = operator in listOf(Operator.EQ, Operator.NE) && Arb.element(true, false).bind()
        val value = if (isWord) words.bind() else numbers.bind()
        Condition.Argument(Arb.int(0..3).bind(), TermTest.Compare(operator, GroundTerm.of(value)))
    }
    val rules = arbitrary {
        Rule(argo.filters.Predicate.of(Arb.element("dist", "dist", "~dist").bind()), Arb.list(conditions, 0..3).bind())
    }

    val less = TermTest.Compare(Operator.LT, GroundTerm.of("15"))
    val isFront = Condition.Argument(0, TermTest.Compare(Operator.EQ, GroundTerm.of("f")))

    test("a rule that is smoothed is mapped to none, and so is one with a second limit for several sensors, or with another condition") {
        fun isMapped(vararg conditions: Condition, smoothed: Boolean = false) =
            boardRuleOf(CriticalRule(Rule("dist", *conditions), smoothed = smoothed)) != null
        isMapped(isFront, Condition.Argument(1, less, 20.0)) shouldBe true
        isMapped(Condition.Argument(0, less, 20.0)) shouldBe true
        isMapped(isFront, Condition.Argument(1, less), smoothed = true) shouldBe false
        isMapped(Condition.Argument(1, less, 20.0)) shouldBe false
        isMapped(isFront, Condition.Argument(2, less, 20.0)) shouldBe false
        isMapped(isFront, Condition.Argument(1, less, 20.0), Condition.Argument(2, less)) shouldBe false
    }

    test("a board that watches a second limit begins as often as the filter's rule does") {
        val critical = CriticalRule(Rule("dist", isFront, Condition.Argument(1, less, 20.0)), "stop")
        val absent = 23
        checkAll(500, Arb.list(Arb.int(13..absent), 1..30), Arb.list(Arb.int(13..22), 30..30)) { front, left ->
            val board = HeldRules(1).apply { change(checkNotNull(boardRuleOf(critical)).setting(1)) }
            val session = FilterSession.ofTexts().apply { switchTo(PerceptionFilter("f", emptyList(), critical = listOf(critical))) }
            var wasMet = false
            front.forEachIndexed { i, cm ->
                val percepts = listOfNotNull("dist(l,${left[i]})", "dist(f,$cm)".takeIf { cm != absent })
                val isMet = session.perceive(percepts, i.toLong()).critical.isNotEmpty()
                board.look(percepts.map { "$it;" }).isNotEmpty() shouldBe (isMet && !wasMet)
                wasMet = isMet
            }
        }
    }

    test("a rule that is mapped to a board decides as the filter does") {
        var mapped = 0
        var met = 0
        checkAll(20 * PropertyTesting.defaultIterationCount, rules, percepts) { rule, percept ->
            val critical = CriticalRule(rule, "stop")
            val boardRule = boardRuleOf(critical) ?: return@checkAll
            mapped++
            val byFilter = PerceptionFilter("f", emptyList(), critical = listOf(critical)).matcher().criticalRules(percept).isNotEmpty()
            if (byFilter) met++
            withClue("$rule, which the board has as $boardRule, and $percept") {
                HeldRules.isMet(boardRule, PerceptTerm.of("$percept;"), false) shouldBe byFilter
            }
        }
        mapped shouldBeGreaterThan 5 * PropertyTesting.defaultIterationCount
        met shouldBeGreaterThan PropertyTesting.defaultIterationCount / 2
    }
})
