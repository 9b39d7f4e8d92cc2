package javino

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.optional.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.arbitrary.orNull
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import javino.PerceptArgument.Anything
import javino.PerceptArgument.Choice
import javino.PerceptArgument.Quantity
import java.math.BigDecimal
import java.math.RoundingMode
import java.util.Optional

private fun quantity(unit: String, min: String?, max: String?) =
    Quantity(unit, Optional.ofNullable(min).map(::BigDecimal), Optional.ofNullable(max).map(::BigDecimal))

private val numbers = Arb.element("0", "-1", "400", "12.50", "-0.5", "1023")
private val limits: Arb<BigDecimal?> = Arb.numericDouble(-1e6, 1e6).map { it.toBigDecimal().setScale(3, RoundingMode.HALF_UP) }.orNull()
private val units = Arb.element("", "cm", "%", "°C", "m/s^2", "rpm")
private val quantities: Arb<PerceptArgument> = Arb.bind(units, limits, limits) { unit, one, other ->
    val (min, max) = if (one != null && other != null) minOf(one, other) to maxOf(one, other) else one to other
    Quantity(unit, Optional.ofNullable(min), Optional.ofNullable(max))
}
private val atoms = Arb.element("front", "f", "a_B9", "on")
private val choices: Arb<PerceptArgument> = Arb.list(Arb.choice(numbers, atoms), 1..5).map { Choice(it) }
private val kinds: Arb<PerceptKind> = Arb.bind(
    Arb.element("dist", "~wall", "lineLeft2", "x_"),
    Arb.list(Arb.choice(Arb.constant<PerceptArgument>(Anything()), choices, quantities), 0..4),
) { functor, arguments -> PerceptKind(functor, arguments) }

private fun deviation(kind: String, percept: String) = PerceptKind.parse(kind).deviationOf(PerceptTerm.of(percept)).orElse(null)

class PerceptKindSpec : FunSpec({
    test("the text of a kind has a functor and, of each argument, anything, a choice, or a number's unit and range") {
        PerceptKind.parse("dist(front|left|right, cm 0..400)") shouldBe
            PerceptKind("dist", listOf(Choice(listOf("front", "left", "right")), quantity("cm", "0", "400")))
        PerceptKind.parse("light(left|right, % 0..100);").arguments()[1] shouldBe quantity("%", "0", "100")
        PerceptKind.parse("button(0|1)").arguments() shouldBe listOf(Choice(listOf("0", "1")))
        PerceptKind.parse("temp(-40..125.5)").arguments() shouldBe listOf(quantity("", "-40", "125.5"))
        PerceptKind.parse("gps(_, _)").arguments() shouldBe listOf(Anything(), Anything())
        PerceptKind.parse("ready") shouldBe PerceptKind("ready", listOf())
        PerceptKind.parse("~wall(silent)").arguments() shouldBe listOf(Choice(listOf("silent")))
        PerceptKind.parse("speed(cm/s ..)").arguments() shouldBe listOf(quantity("cm/s", null, null))
        PerceptKind.parse("height(..0)").arguments() shouldBe listOf(quantity("", null, "0"))
        PerceptKind.parse("  dist ( front | left ,cm  0 .. 400 ) ;").toString() shouldBe "dist(front|left, cm 0..400)"
    }

    test("the text of any kind is read back as that kind") {
        checkAll(kinds) { kind -> PerceptKind.parse(kind.toString()) shouldBe kind }
    }

    test("any text is a kind or refused with a reason") {
        checkAll(2 * PropertyTesting.defaultIterationCount, Arb.string(0..30), Arb.element("", "d(", "d(a, ", "d(cm ")) { rest, start ->
            try {
                PerceptKind.parse(start + rest).let { PerceptKind.parse(it.toString()) shouldBe it }
            } catch (refusal: IllegalArgumentException) {
                withClue(refusal) { (refusal.message!!.length > 20) shouldBe true }
            }
        }
    }

    test("a text that is no kind is refused with the place, what was found and what could stand there") {
        fun refusal(text: String) = shouldThrow<IllegalArgumentException> { PerceptKind.parse(text) }.message!!
        refusal("dist(front|, cm 0..400)") shouldBe "argument 1 of dist(front|, cm 0..400): \"front|\" cannot be read; " +
            "write _ for anything, a choice as front|left, or a number's unit and range as cm 0..400"
        refusal("dist(f, cm 400..0)") shouldContain "argument 2 of dist(f, cm 400..0): the range begins at 400 and ends before, at 0"
        refusal("Dist(_)") shouldContain "\"Dist\" is no functor"
        refusal("dist(_)light(_)") shouldContain "argument 1"
        refusal("dist(_") shouldContain "describes no percepts"
        refusal("") shouldContain "is no functor"
        listOf("dist()", "dist(cm 0..4,)", "dist(\u2126 0..4)", "dist(0..4 cm)", "dist(\"a\")", "dist([1,2])", "dist(1 0..4)")
            .forEach(::refusal)
    }

    test("a file has a kind a line, with comments, and names the line that cannot be read") {
        PerceptKind.parseLines("# of the robot\ndist(cm 0..400) # front\r\n\n  ready;\n").map { "$it" } shouldBe
            listOf("dist(cm 0..400)", "ready")
        shouldThrow<IllegalArgumentException> { PerceptKind.parseLines("ready\n\ndist(") }.message shouldContain "line 3: "
    }

    test("a percept deviates by its functor, its number of arguments or an argument") {
        deviation("dist(front|left, cm 0..400)", "dist(front,38);") shouldBe null
        deviation("dist(front|left, cm 0..400)", "dist( left , 4e2 )[at(3)]") shouldBe null
        deviation("dist(front|left, cm 0..400)", "dist(front,401)") shouldBe "argument 2 is 401, more than 400"
        deviation("dist(front|left, cm 0..400)", "dist(front,-0.5)") shouldBe "argument 2 is -0.5, less than 0"
        deviation("dist(front|left, cm 0..400)", "dist(front,near)") shouldBe "argument 2 is near, no number"
        deviation("dist(front|left, cm 0..400)", "dist(up,40)") shouldBe "argument 1 is up, none of front, left"
        deviation("dist(front|left, cm 0..400)", "dist(40)") shouldBe "dist/1 is not dist/2"
        deviation("wall(ahead)", "~wall(ahead)") shouldBe "~wall/1 is not wall/1"
        deviation("wall(ahead)", "wall(\"ahead\")") shouldBe "argument 1 is \"ahead\", not ahead"
        deviation("button(0|1)", "button(1.0)") shouldBe null
        deviation("gps(_)", "gps(\"48.1, 11.5\")") shouldBe null
    }

    test("units are shown behind the numbers of a percept") {
        val kinds = PerceptKind.parseLines("dist(front|left, cm 0..400)\ndist(back, inch 0..150)\nlight(% ..)\nready\ncount(0..9)")
        fun shown(percept: String): String? {
            val term = PerceptTerm.of(percept)
            return PerceptKind.of(term, kinds).map { it.withUnits(term) }.orElse(null)
        }
        shown("dist(left, 38)[at(1)]") shouldBe "dist(left,38 cm)"
        shown("dist(back,38)") shouldBe "dist(back,38 inch)"
        shown("dist(up,38)") shouldBe "dist(up,38 cm)"
        shown("light(5)") shouldBe "light(5 %)"
        shown("ready") shouldBe "ready"
        shown("count(3)") shouldBe "count(3)"
        shown("light") shouldBe null
    }

    test("of several kinds a percept needs to be of one") {
        val kinds = PerceptKind.parseLines("dist(front, cm 0..400)\ndist(back, cm 0..50)\nready\nlight(0..10)")
        fun deviation(percept: String) = PerceptKind.deviationOf(PerceptTerm.of(percept), kinds)
        deviation("dist(back,50)").shouldBeEmpty()
        deviation("dist(back,51)").get() shouldBe "it is none of dist(front, cm 0..400) and dist(back, cm 0..50)"
        deviation("light(11)").get() shouldBe "argument 1 is 11, more than 10"
        deviation("ready(1)").get() shouldBe "no ready/1 is described"
    }
})
