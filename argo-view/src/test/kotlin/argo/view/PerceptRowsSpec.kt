package argo.view

import argo.observing.PerceivedMessage
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.comparables.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import javino.PerceptKind

private const val MS = 1_000_000L

class PerceptRowsSpec : FunSpec({
    fun frame(
        texts: List<String>, kept: List<String> = texts, atMs: Long = 0, unreadable: Set<String> = emptySet(), port: String = "sim:robot",
    ): PerceivedMessage = Message(texts, kept, unreadable, atMs * MS, port)
    fun PerceptRows.texts(nowMs: Long) = state(nowMs * MS) { false }.first.map { it.text }

    test("each percept is what the filter made of it") {
        val rows = PerceptRows()
        val kept = listOf("dist(f,1)", "temp(19)", "X")
        rows.add(frame(listOf("dist(f,1)", "light(b,2)", "temp(20)", "X"), kept, unreadable = setOf("X")), isAlone = true)
        rows.state(0) { false }.first.map { it.text to it.fate } shouldBe
            listOf("dist(f,1)" to "kept", "light(b,2)" to "dropped", "temp(20)" to "held", "X" to "unreadable")
    }

    test("a percept that another one stands for is held back, and the annotation of one that stands does not hide it") {
        val rows = PerceptRows()
        val kept = listOf("dist(f,40)", "dist(b,3)[q(1),smoothed]", "light(1)[smoothed]")
        rows.add(frame(listOf("dist(f,300)", "dist(b,3)[q(1)]", "light(2)"), kept), isAlone = true)
        rows.state(0) { false }.first.map { it.text to it.fate } shouldBe
            listOf("dist(f,300)" to "held", "dist(b,3)[q(1)]" to "kept", "light(2)" to "held")
    }

    test("a sensor keeps its place, and tells how long it has said the same") {
        val rows = PerceptRows()
        rows.add(frame(listOf("dist(f,1)", "light(5)"), atMs = 0), isAlone = true)
        rows.add(frame(listOf("light(5)", "dist(f,2)"), atMs = 100), isAlone = true)
        rows.state(150 * MS) { false }.first.map { Triple(it.text, it.ageMs, it.sameMs) } shouldBe
            listOf(Triple("dist(f,2)", 50L, 50L), Triple("light(5)", 50L, 150L))
    }

    test("a sensor that falls silent is shown with its age for a while, then not") {
        val rows = PerceptRows()
        rows.add(frame(listOf("a(1)", "b(1)"), atMs = 0), isAlone = true)
        rows.add(frame(listOf("b(2)"), atMs = 9000), isAlone = true)
        rows.texts(9000) shouldBe listOf("a(1)", "b(2)")
        rows.texts(11_000) shouldBe listOf("b(2)")
    }

    test("the sensors of a board that is silent stay, however long it is, until it is not perceived any more") {
        val rows = PerceptRows()
        rows.add(frame(listOf("a(1)", "b(1)"), atMs = 0), isAlone = true)
        rows.add(frame(listOf("b(2)"), atMs = 11_000), isAlone = true)
        rows.state(60_000 * MS) { true }.first.map { it.text to it.silent } shouldBe listOf("b(2)" to true)
        rows.state(60_000 * MS) { false }.first shouldBe emptyList()
    }

    test("boards that are perceived together have rows each, and those of a silent one are known") {
        val rows = PerceptRows()
        rows.add(frame(listOf("dist(1)"), port = "left"), isAlone = false)
        rows.add(frame(listOf("dist(2)"), port = "right"), isAlone = false)
        rows.state(0) { it == "left" }.first.map { it.text to it.silent } shouldBe listOf("dist(1)" to true, "dist(2)" to false)
    }

    test("a board that is perceived alone takes the place of the one before") {
        val rows = PerceptRows()
        rows.add(frame(listOf("dist(1)"), port = "left"), isAlone = true)
        rows.add(frame(listOf("dist(2)"), port = "right"), isAlone = true)
        rows.texts(0) shouldBe listOf("dist(2)")
    }

    test("percepts of the same form in one message are shown each by itself") {
        val rows = PerceptRows()
        rows.add(frame(listOf("seen(1,2)", "seen(3,4)")), isAlone = true)
        rows.state(0) { false }.first.map { it.key }.shouldHaveSize(2).shouldBeUnique()
    }

    test("a number in a name is a name") {
        val rows = PerceptRows()
        rows.add(frame(listOf("light1(5)", "light2(6)"), atMs = 0), isAlone = true)
        rows.add(frame(listOf("light2(7)"), atMs = 10), isAlone = true)
        rows.texts(10) shouldBe listOf("light1(5)", "light2(7)")
    }

    test("the numbers of a sensor have a course, also when they come in another order; a sensor without a number has none") {
        val rows = PerceptRows()
        rows.add(frame(listOf("pos(1,-2.5)", "lamp(on)")), isAlone = true)
        rows.add(frame(listOf("lamp(on)", "pos(3,4e1)"), atMs = 1000), isAlone = true)
        rows.courses(1000 * MS).values.single().map { it.filterNotNull() } shouldBe listOf(listOf(1.0, 3.0), listOf(-2.5, 40.0))
        rows.courses(1000 * MS).keys.single() shouldBe rows.state(1000 * MS) { false }.first.first().key
    }

    test("a board that describes its percepts gives units and ranges to their numbers, and a reason to those that are not as described") {
        val rows = PerceptRows()
        val kinds = PerceptKind.parseLines("dist(f|b, cm 0..400)\npos(m .., _, deg -180..180)\nready")
        rows.add(frame(listOf("dist(f,401)", "pos(1.5,[2,3],7)[at(9)]", "ready", "news(1)")), isAlone = true)
        val described = rows.state(0, { kinds }) { false }.first.map { checkNotNull(it.described) }
        described.map { it.text } shouldBe listOf("dist(f,401 cm)", "pos(1.5 m,[2,3],7 deg)", "ready", "news(1)")
        described.map { it.deviation } shouldBe listOf("argument 2 is 401, more than 400", null, null, "no news/1 is described")
        described.map { it.ranges } shouldBe listOf(
            listOf(NumberRange("cm", 0.0, 400.0)),
            listOf(NumberRange("m", null, null), null, null, NumberRange("deg", -180.0, 180.0)),
            emptyList(),
            emptyList(),
        )
        rows.state(0) { false }.first.map { it.described }.toSet() shouldBe setOf(null)
    }

    test("however much a board says, few rows are kept") {
        val rows = PerceptRows()
        rows.add(frame((1..5000).map { "p$it" } + "x".repeat(100_000)), isAlone = true)
        rows.add(frame((1..5000).map { "q$it" }), isAlone = true)
        val (shown, more) = rows.state(0) { false }
        shown.size shouldBeLessThanOrEqual 200
        more shouldBe 4800
        shown.forEach { it.text.length shouldBeLessThan 400 }
    }

    test("percepts of several boards for which there is no room are counted, until their board has long said nothing else") {
        val rows = PerceptRows()
        listOf("left" to 0L, "right" to 5000L).forEach { (port, ms) ->
            rows.add(frame((1..150).map { "$port$it" }, atMs = ms, port = port), isAlone = false)
        }
        rows.state(6000 * MS) { false }.run { first.size to second } shouldBe (200 to 100)
        rows.state(11_000 * MS) { false }.run { first.size to second } shouldBe (150 to 0)
    }

    test("courses that are too many are counted") {
        val rows = PerceptRows()
        rows.add(frame((1..70).map { "s$it(1)" } + "lamp"), isAlone = true)
        rows.courses(0).size to rows.moreCourses shouldBe (60 to 10)
    }
})

private class Message(
    override val texts: List<String>,
    override val kept: List<String>,
    override val unreadable: Set<String>,
    override val receivedNanos: Long,
    override val portName: String,
) : PerceivedMessage
