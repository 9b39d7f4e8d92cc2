package argo.filters

import argo.filters.PerceptionFilter.Mode
import argo.filters.PerceptionFilter.OnSwitch
import argo.filters.format.XmlFilters
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

object Distance : PerceptType("distance") {
    val side by atom()
    val cm by number()
}

object Said : PerceptType("~said") {
    val text by string()
    val where by term()
}

class FilterDslSpec : StringSpec({
    "a filter has the rules that are written, in their order" {
        val filter = dropFilter("frontDistance") {
            drop("temperature")
            drop("distance") { argument(0) ne "front" }
        }
        filter shouldBe PerceptionFilter(
            "frontDistance",
            Rule("temperature"),
            Rule("distance", Condition.Argument(0, TermTest.Compare(Operator.NE, GroundTerm.of("front")))),
        )
        filter.name shouldBe "frontDistance"
        filter.mode shouldBe Mode.DROP
        filter.onSwitch shouldBe OnSwitch.FORGET
    }

    "typed conditions are those on the argument's number" {
        val typed = dropFilter("typed") {
            drop(Distance) {
                side ne "front"
                cm gt 200
            }
            drop(Distance)
            drop(Said) { text eq "hi, \"you\""; where ne "pos( 1,2 )" }
        }
        typed shouldBe dropFilter("untyped") {
            drop("distance") { argument(0) ne "front"; argument(1) gt 200 }
            drop("distance")
            drop("~said") { argument(0) eq "\"hi, \\\"you\\\"\""; argument(1) ne "pos(1,2)" }
        }
    }

    "every word means what it says" {
        val filter = dropFilter("all", OnSwitch.FREEZE) {
            drop("d") {
                arity(3)
                everyMs(500)
                deadband(2)
                argument(0) eq "a"; argument(0) eq 1; argument(0) eq GroundTerm.Text("A")
                argument(0) ne "a"; argument(0) ne 1.5; argument(0) ne GroundTerm.Text("A")
                argument(1) gt 1; argument(1) ge 2L; argument(1) lt 3f; argument(1) le 4.0
                argument(2) matches "a.*"
                argument(2) isIn listOf("a", 1, GroundTerm.Text("A"))
                argument(2) deadband 0.5
                hasAnnotation("urgent")
                annotation("q") lt 0.5
                annotation("q") { gt(1); ne("x") }
            }
        }
        filter shouldBe XmlFilters.read(
            """
            <PerceptionFilter onSwitch="freeze">
              <filter arity="3" everyMs="500" deadband="2">
                <predicate>d</predicate>
                <parameter id="0">a</parameter><parameter id="0">1</parameter><parameter id="0">"A"</parameter>
                <parameter id="0" operator="NE">a</parameter><parameter id="0" operator="NE">1.5</parameter>
                <parameter id="0" operator="NE">"A"</parameter>
                <parameter id="1" operator="GT">1</parameter><parameter id="1" operator="GE">2</parameter>
                <parameter id="1" operator="LT">3</parameter><parameter id="1" operator="LE">4</parameter>
                <parameter id="2" operator="MATCHES">a.*</parameter>
                <parameter id="2" operator="IN">[a,1,"A"]</parameter>
                <parameter id="2" deadband="0.5"/>
                <annotation name="urgent"/>
                <annotation name="q" operator="LT">0.5</annotation>
                <annotation name="q"><limit operator="GT">1</limit><limit operator="NE">x</limit></annotation>
              </filter>
            </PerceptionFilter>
            """.trimIndent(),
            "all.xml",
        )
    }

    "every typed word means what its untyped twin says" {
        val typed = dropFilter("typed") {
            drop(Distance) {
                arity(2)
                everyMs(10)
                hasAnnotation("u")
                annotation("q") ge 1
                annotation("r") { gt(0); lt(1) }
                deadband(3)
                side eq "a"; side ne "b"; side isIn listOf("c", "d"); side matches "e"
                cm eq 1; cm ne 2; cm gt 3; cm ge 4; cm lt 5; cm le 6; cm isIn listOf(7, 8.0); cm deadband 9
            }
            drop(Said) {
                text ne "a"; text isIn listOf("b", "c"); text matches "d"
                where eq "e"; where isIn listOf("f", "1"); where matches "g"
            }
        }
        typed shouldBe dropFilter("untyped") {
            drop("distance") {
                arity(2)
                everyMs(10)
                hasAnnotation("u")
                annotation("q") ge 1
                annotation("r") { gt(0); lt(1) }
                deadband(3)
                argument(0) eq "a"; argument(0) ne "b"; argument(0) isIn listOf("d", "c"); argument(0) matches "e"
                argument(1) eq 1; argument(1) ne 2; argument(1) gt 3; argument(1) ge 4
                argument(1) lt 5; argument(1) le 6
                argument(1) isIn listOf(7, 8); argument(1) deadband 9
            }
            drop("~said") {
                argument(0) ne "\"a\""; argument(0) isIn listOf("\"b\"", "\"c\""); argument(0) matches "d"
                argument(1) eq "e"; argument(1) isIn listOf("f", 1); argument(1) matches "g"
            }
        }
    }

    "a filter that keeps is written with keep" {
        val filter = keepFilter("front") {
            keep(Distance) { side eq "front" }
            keep("bumper")
        }
        filter shouldBe PerceptionFilter(
            "x",
            listOf(Rule("distance", Condition.Argument(0, TermTest.Compare(Operator.EQ, GroundTerm.of("front")))), Rule("bumper")),
            Mode.KEEP,
        )
    }

    "a filter includes another's rules where it says so" {
        val light = dropFilter("light") { drop("light") }
        dropFilter("all") { drop("a"); include(light); drop("b") } shouldBe dropFilter("x") { drop("a"); drop("light"); drop("b") }
    }

    "a filter that keeps does not include one that drops, nor the other way round" {
        val dropping = dropFilter("dropping") { drop("a") }
        val keeping = keepFilter("keeping") { keep("a") }
        shouldThrow<IllegalArgumentException> { keepFilter("x") { include(dropping) } }.message shouldContain
            "filter dropping cannot be included"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { include(keeping) } }.message shouldContain
            "filter keeping cannot be included"
    }

    "an argument or annotation without a condition is refused" {
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { argument(1) } } }.message shouldContain
            "there is no condition on argument(1) in a rule on d"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { annotation("q") } } }.message shouldContain
            "annotation(\"q\")"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop(Distance) { side } } }.message shouldContain
            "there is no condition on side in a rule on distance"
        shouldThrow<IllegalArgumentException> { keepFilter("x") { keep(Distance) { cm gt 3; cm; side } } }.message shouldContain
            "there is no condition on cm and side in"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { critical(Distance) { cm; reflex("stop") } } }.message shouldContain
            "there is no condition on cm"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop(Distance) { annotation("q") } } }.message shouldContain
            "annotation(\"q\")"
    }

    "an argument may be used again, and one that was read outside of the rule" {
        val far = Distance.cm
        dropFilter("x") { drop(Distance) { far gt 3; val near = cm; near gt 1; near lt 9 } } shouldBe
            dropFilter("x") { drop("distance") { argument(1) gt 3; argument(1) gt 1; argument(1) lt 9 } }
    }

    "an argument of another type is refused" {
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop(Distance) { Said.where eq "a" } } }.message shouldBe
            "where is an argument of ~said, and the rule is on distance"
    }

    "a range is from one number to another, both included, and all between" {
        val ranges = dropFilter("x") {
            drop(Distance) { cm isIn 1..5 }
            drop("d") { argument(0) isIn 0.5..2.0; annotation("q") isIn 0L..1L; annotation("r") { isIn(2..3); ne(3) } }
        }
        ranges shouldBe dropFilter("x") {
            drop("distance") { argument(1) ge 1; argument(1) le 5 }
            drop("d") { argument(0) ge 0.5; argument(0) le 2; annotation("q") { ge(0); le(1) }; annotation("r") { ge(2); le(3); ne(3) } }
        }
        @Suppress("EmptyRange")
        val empty = 5..1
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop(Distance) { cm isIn empty } } }.message shouldContain "5..1 is empty"
    }

    "an interval is a duration, too" {
        dropFilter("x") { drop("d") { every(2.seconds) }; drop(Distance) { every(5.milliseconds) } } shouldBe
            dropFilter("x") { drop("d") { everyMs(2_000) }; drop(Distance) { everyMs(5) } }
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { every(1.5.milliseconds) } } }.message shouldContain "1.5ms"
    }

    "a name by which no agent can ask for the filter is refused" {
        for ((name, reason) in listOf("" to "it is empty", "none" to "ends the filtering", "../a" to "'..'", "a:b" to "one of")) {
            shouldThrow<IllegalArgumentException> { dropFilter(name) { drop("d") } }.message shouldContain reason
            shouldThrow<IllegalArgumentException> { keepFilter(name) { keep("d") } }.message shouldContain reason
        }
        dropFilter("night/dark") { drop("d") }.name shouldBe "night/dark"
    }

    "what a file is refused for is refused here" {
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("Dist") } }.message shouldContain "'Dist' is no functor"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { argument(-1) eq 1 } } }.message shouldContain "none at -1"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { argument(0) eq "Front" } } }.message shouldContain "variable"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { argument(0) matches "(" } } }.message shouldContain
            "not a regular expression"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { argument(0) isIn emptyList() } } }.message shouldContain
            "at least one"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { argument(0) isIn listOf(true) } } }.message shouldContain
            "is no value"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { arity(-1) } } }
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { arity(1); arity(2) } } }.message shouldContain
            "the arity 1 already"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop(Distance) { everyMs(10); everyMs(20) } } }.message shouldContain
            "the interval 10 ms already"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { deadband(1); deadband(2) } } }.message shouldContain
            "two deadbands"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop("d") { everyMs(0) } } }
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop(Distance) { side eq "pos(1)" } } }.message shouldContain
            "not an atom"
        shouldThrow<IllegalArgumentException> { dropFilter("x") { drop(Distance) { cm deadband 0 } } }
    }
})
