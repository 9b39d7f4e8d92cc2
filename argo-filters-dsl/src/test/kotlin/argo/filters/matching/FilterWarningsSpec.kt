package argo.filters.matching

import argo.filters.Condition
import argo.filters.DropRules
import argo.filters.GroundTerm
import argo.filters.KeepRules
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.TermTest
import argo.filters.dropFilter
import argo.filters.filters
import argo.filters.format.JsonFilters
import argo.filters.format.XmlFilters
import argo.filters.keepFilter
import argo.filters.perceptTexts
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

private fun drop(rules: DropRules.() -> Unit) = dropFilter("f", rules = rules)

private fun keep(rules: KeepRules.() -> Unit) = keepFilter("f", rules = rules)

private val WITHOUT_EFFECT: Map<PerceptionFilter, List<String>> = mapOf(
    drop {} to listOf("the filter has no rules, so it keeps every percept"),
    keep {} to listOf("the filter has no rules, so it drops every percept"),
    drop { drop("d") { argument(1) gt 5; argument(1) lt 3 } } to listOf(
        "rule 1 (d where argument 1 is greater than 5 and argument 1 is less than 3) matches no percept: " +
            "argument 1 is greater than 5 and argument 1 is less than 3",
    ),
    keep { keep("d") { argument(0) eq "a"; argument(0) eq "b" } } to
        listOf("rule 1 (d where argument 0 is a and argument 0 is b) matches no percept: argument 0 is a and argument 0 is b"),
    drop { drop("d") { argument(0) eq "a"; argument(0) gt 3 } } to listOf(
        "rule 1 (d where argument 0 is a and argument 0 is greater than 3) matches no percept: argument 0 is a and argument 0 is greater than 3",
    ),
    drop { drop("d") { argument(0) isIn 3..3; argument(0) ne 3 } } to listOf(
        "rule 1 (d where argument 0 is at least 3 and argument 0 is at most 3 and argument 0 is not 3) matches no percept: " +
            "argument 0 is at least 3 and argument 0 is at most 3 and argument 0 is not 3",
    ),
    drop { drop("d") { annotation("q") { gt(1); le(1) } } } to listOf(
        "rule 1 (d where annotation q is greater than 1 and is at most 1) matches no percept: " +
            "annotation q is greater than 1 and is at most 1",
    ),
    drop { drop("d") { arity(1); argument(1) eq 3 } } to listOf(
        "rule 1 (d where there is 1 argument and argument 1 is 3) matches no percept: argument 1 is 3, and there is no such argument",
    ),
    drop { critical("d") { argument(0) lt 1; argument(0) gt 2; reflex("stop") } } to listOf(
        "critical rule 1 (d where argument 0 is less than 1 and argument 0 is greater than 2) matches no percept: " +
            "argument 0 is less than 1 and argument 0 is greater than 2",
    ),
    drop { drop("d"); drop("d") } to listOf("rule 2 (d) has no effect: rule 1 (d) matches the same percepts"),
    drop { drop("d") { argument(0) eq "a" }; drop("d") } to
        listOf("rule 1 (d where argument 0 is a) has no effect: rule 2 (d) matches the same percepts"),
    keep { keep("d") { argument(1) gt 5; everyMs(9) }; keep("d") { argument(1) ge 5 } } to listOf(
        "rule 1 (d where argument 1 is greater than 5 and the last one was less than 9 ms ago) has no effect: " +
            "rule 2 (d where argument 1 is at least 5) matches the same percepts",
    ),
    drop { drop("d") { argument(0) isIn listOf("a", "b") }; drop("d") { argument(0) ne "c" } } to listOf(
        "rule 1 (d where argument 0 is one of a, b) has no effect: rule 2 (d where argument 0 is not c) matches the same percepts",
    ),
    drop { critical("d") { reflex("stop") }; critical("d") { argument(0) gt 3; reflex("stop") } } to listOf(
        "critical rule 2 (d where argument 0 is greater than 3) has no effect: critical rule 1 (d) matches the same percepts",
    ),
    drop { critical("d"); drop("d") { everyMs(5) } } to listOf(
        "rule 1 (d where the last one was less than 5 ms ago) has no effect: critical rule 1 (d) keeps all percepts that match it",
    ),
    drop { drop("d") { argument(0) gt 5; argument(0) gt 3 } } to listOf(
        "rule 1 (d where argument 0 is greater than 5 and argument 0 is greater than 3) does not need its condition " +
            "'argument 0 is greater than 3': the other conditions imply it",
    ),
    drop { drop("d") { hasAnnotation("q"); hasAnnotation("q") } } to listOf(
        "rule 1 (d where there is an annotation q and there is an annotation q) does not need its condition " +
            "'there is an annotation q': the other conditions imply it",
    ),
    drop { drop("d") { arity(1); argument(2) deadband 5 } } to listOf(
        "rule 1 (d where there is 1 argument and argument 2 has not moved by 5) has a deadband on argument 2, " +
            "and there is no such argument",
    ),
    drop { smooth("d") { argument(1) median 3 }; smooth("d") { argument(0) eq "a"; argument(1) median 5 } } to listOf(
        "smoothing rule 2 (d where argument 0 is a) has no effect: smoothing rule 1 (d) smooths all percepts that match it",
    ),
    drop { smooth("d") { arity(1); argument(1) median 3 } } to
        listOf("smoothing rule 1 (d where there is 1 argument) smooths argument 1, and there is no such argument"),
    drop { smooth("d") { argument(1) eq 40; argument(1) median 3 } } to listOf(
        "smoothing rule 1 (d where argument 1 is 40) smooths argument 1, and has a condition that leaves nothing to smooth there",
    ),
    keep { smooth("d") { argument(1) median 3 } } to listOf("the filter has no rules, so it drops every percept"),
    drop { critical("d") { smoothed() } } to listOf("critical rule 1 (d) is smoothed, and there is no smoothing rule on d"),
    drop { drop("d") { argument(0) lt 40 until 45 }; drop("d") { argument(0) lt 40 } } to listOf(
        "rule 2 (d where argument 0 is less than 40) has no effect: " +
            "rule 1 (d where argument 0 is less than 40 until 45) matches the same percepts",
    ),
    drop { drop("d") { argument(0) lt 40 until 45; argument(0) lt 50 } } to listOf(
        "rule 1 (d where argument 0 is less than 40 until 45 and argument 0 is less than 50) does not need its condition " +
            "'argument 0 is less than 50': the other conditions imply it",
    ),
)

/** Filters whose parts all have an effect, although it may not seem so. */
private val WITH_EFFECT = listOf(
    drop { drop("d"); drop("~d"); drop("house::d") },
    drop { drop("d") { argument(0) eq "a" }; drop("d") { argument(0) eq "b" } },
    drop { drop("d") { argument(0) eq "front" }; drop("d") { argument(0) eq "\"front\"" } },
    drop { drop("d") { argument(0) gt 3; argument(0) ne 5; argument(0) matches "4.*" } },
    drop { drop("d") { annotation("q") gt 5; annotation("q") lt 3 } }, // two annotations may have this name
    drop { drop("d") { everyMs(9) }; drop("d") { argument(0) eq "a" } },
    drop { drop("d") { everyMs(9) }; drop("d") { argument(0) eq "a"; everyMs(99) } },
    drop { drop("d") { arity(1) }; drop("d") { argument(0) eq "a" } },
    drop { drop("d") { argument(0) ne "a" }; drop("d") { argument(1) ne "a" } },
    drop { critical("d") { reflex("stop") }; critical("d") { argument(0) gt 3; reflex("back") } },
    drop { critical("d") { argument(0) gt 3 }; drop("d") },
    keep { critical("d") },
    drop { smooth("d") { argument(0) median 3 } },
    drop { smooth("d") { argument(0) lt 400; argument(0) median 3 } },
    drop { smooth("d") { argument(0) eq "a"; argument(1) median 3 }; smooth("d") { argument(1) median 5 } },
    drop { smooth("d") { argument(0) median 3 }; critical("d") { argument(0) lt 5 }; drop("d") { argument(0) lt 5 } },
    drop { smooth("d") { argument(0) median 3 }; critical("d") { argument(0) lt 5; smoothed() }; critical("d") { argument(0) lt 5 } },
    drop { drop("d") { argument(0) lt 40 until 45 }; drop("d") { argument(0) lt 43 } },
    drop { drop("d") { argument(0) lt 40 until 60; argument(0) lt 50 } },
)

private val USELESS_RULE = Regex("^rule (\\d+) .*(matches no percept|has no effect)", RegexOption.DOT_MATCHES_ALL)

private fun forms(filter: PerceptionFilter) = listOf(
    filter, XmlFilters.read(XmlFilters.write(filter), "f.xml"), JsonFilters.read(JsonFilters.write(filter), "f.json"),
)

class FilterWarningsSpec : FunSpec({
    WITHOUT_EFFECT.forEach { (filter, warnings) ->
        test("$filter, in all forms: ${warnings.joinToString().substringAfter(") ")}") {
            forms(filter).forEach { it.warnings() shouldContainExactly warnings }
        }
    }

    WITH_EFFECT.forEach { filter -> test("nothing is said of $filter") { filter.warnings().shouldBeEmpty() } }

    test("a filter whose name no agent can ask for") {
        PerceptionFilter("none", Rule("d")).warnings() shouldContainExactly
            listOf("no agent can ask for a filter of the name 'none': argo.change_filter(none) ends the filtering")
    }

    test("a rule that covers another is found among those of other predicates and first arguments") {
        fun d(vararg tests: TermTest) = Rule("d", *tests.map { Condition.Argument(0, it) }.toTypedArray())
        val one = TermTest.OneOf(setOf(GroundTerm.Number(1.0)))
        val range = arrayOf(TermTest.Compare(Operator.GE, GroundTerm.Number(1.0)), TermTest.Compare(Operator.LE, GroundTerm.Number(1.0)))
        fun superfluous(vararg rules: Rule) =
            PerceptionFilter("f", *rules).warnings()
                .map { it.substringBefore(" (") + it.substringAfter("has no effect").substringBefore(" (") }
        superfluous(Rule("e"), d(one), Rule("e"), d(TermTest.Compare(Operator.EQ, GroundTerm.of("x"))), d(*range)) shouldContainExactly
            listOf("rule 3: rule 1", "rule 5: rule 2")
        superfluous(d(one), Rule("d")) shouldContainExactly listOf("rule 1: rule 2")
    }

    test("a rule or condition that is said to have no effect has none") {
        checkAll(3 * PropertyTesting.defaultIterationCount, filters, Arb.list(perceptTexts, 0..12)) { filter, percepts ->
            val warnings = filter.warnings()
            val useless = warnings.mapNotNull { USELESS_RULE.find(it)?.groupValues?.get(1)?.toInt() }
            // one at a time: of two equal rules, only one is useless
            useless.forEach { number ->
                val rest = filter.rules.filterIndexed { at, _ -> at != number - 1 }
                val without = PerceptionFilter("f", rest, filter.mode, filter.onSwitch, filter.critical).matcher()
                withClue(warnings) { percepts.filter(without::drops) shouldBe percepts.filter(filter.matcher()::drops) }
            }
        }
    }
})
