package argo.filters

import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FreeSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import org.jetbrains.kotlin.cli.common.ExitCode

/** Correct statements, which must compile. Else the test of incorrect statements proves nothing. */
private val SENSE = listOf(
    "typed conditions" to
        """dropFilter("x") { drop(Distance) { side ne "front"; cm gt 200; label matches "a.*"; """ +
        """annotation("q") { gt(0); lt(1) }; deadband(5) } }""",
    "untyped conditions" to """dropFilter("x") { drop("light") { argument(0) gt 3; argument(1) eq "a" } }""",
    "a critical rule, typed and not" to
        """dropFilter("x") { critical(Distance) { cm lt 15; reflex("stop") }; critical("bump") { argument(0) eq 1; reflex("stop") } }""",
    "ranges, intervals" to
        """dropFilter("x") { drop(Distance) { cm isIn 1..5; every(1.seconds) }; drop("light") { argument(0) isIn 0.5..2.0 } }""",
    "a filter that keeps" to """keepFilter("x") { keep(Distance) { cm ge 200.5 }; keep("light") }""",
)

private val NO_SENSE = listOf(
    "a side is not compared with a number" to """dropFilter("x") { drop(Distance) { side gt 3 } }""",
    "a side does not equal a number" to """dropFilter("x") { drop(Distance) { side eq 3 } }""",
    "a side is in no list of numbers" to """dropFilter("x") { drop(Distance) { side isIn listOf(1, 2) } }""",
    "centimetres do not equal a side" to """dropFilter("x") { drop(Distance) { cm eq "front" } }""",
    "a number matches no pattern" to """dropFilter("x") { drop(Distance) { cm matches "1.*" } }""",
    "a string has no order" to """dropFilter("x") { drop(Distance) { label lt "b" } }""",
    "a side has no deadband" to """dropFilter("x") { drop(Distance) { side deadband 3 } }""",
    "an argument that is not declared" to """dropFilter("x") { drop(Distance) { speed gt 3 } }""",
    "a rule in a rule" to """dropFilter("x") { drop("a") { drop("b") } }""",
    "a rule in a typed rule" to """dropFilter("x") { drop(Distance) { drop("b") } }""",
    "another filter in a rule" to """dropFilter("x") { drop("a") { include(dropFilter("y") {}) } }""",
    "a side in a range of numbers" to """dropFilter("x") { drop(Distance) { side isIn 1..5 } }""",
    "an argument outside a rule" to """dropFilter("x") { argument(0) eq 1 }""",
    "a typed argument outside a rule" to """dropFilter("x") { Distance.cm eq 1 }""",
    "an argument by number in a typed rule" to """dropFilter("x") { drop(Distance) { argument(0) eq 1 } }""",
    "keep in a filter that drops" to """dropFilter("x") { keep("a") }""",
    "drop in a filter that keeps" to """keepFilter("x") { drop("a") }""",
    "an annotation's test outside an annotation" to """dropFilter("x") { drop("a") { gt(1) } }""",
    "a condition of the rule in an annotation's tests" to """dropFilter("x") { drop("a") { annotation("q") { everyMs(1) } } }""",
    "a condition of the rule in an annotation's tests, typed" to
        """dropFilter("x") { drop(Distance) { annotation("q") { everyMs(1) } } }""",
    "a reflex of a rule that drops" to """dropFilter("x") { drop("a") { reflex("stop") } }""",
    "a reflex of a typed rule that drops" to """dropFilter("x") { drop(Distance) { reflex("stop") } }""",
    "a side that is less in a critical rule" to """dropFilter("x") { critical(Distance) { side lt 3 } }""",
    "an argument declared outside its type" to """Distance.atom()""",
)

private const val DECLARATIONS = """
import argo.filters.*
import kotlin.time.Duration.Companion.seconds

object Distance : PerceptType("distance") {
    val side by atom()
    val cm by number()
    val label by string()
}
"""

@Tags("Thorough")
class TypeSafetySpec : FreeSpec({
    "what makes sense compiles" {
        val compilation = Compilation(tempdir(), SENSE.map { it.second }, DECLARATIONS)
        withClue(compilation) { compilation.exit shouldBe ExitCode.OK }
    }

    "what makes no sense does not compile" - {
        val compilation = Compilation(tempdir(), NO_SENSE.map { it.second }, DECLARATIONS)
        NO_SENSE.forEachIndexed { number, (what, _) ->
            what { withClue(compilation) { compilation.errors(number).shouldNotBeEmpty() } }
        }
    }
})
