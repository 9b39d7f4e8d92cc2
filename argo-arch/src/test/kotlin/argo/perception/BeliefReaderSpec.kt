package argo.perception

import argo.acting.Reflexes
import argo.connecting.PortStatus
import argo.filters.foreignText
import argo.filters.matching.OWN_BELIEFS
import argo.sensing.StaleBeliefs
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import jason.asSyntax.ASSyntax

class BeliefReaderSpec : FunSpec({
    val warnings = ArrayList<String>()
    val reader = BeliefReader { warnings += it }
    beforeTest { warnings.clear() }
    fun read(text: String) = reader.read(text)

    test("a percept becomes the literal that Jason reads") {
        for (text in listOf(
            "dist(f,123)", "ready", "~open(door)", "temp(f,-3.5)", "say(\"hi; you\")", "p([1,2|[3]],q(r))", "p(1)[q(0.5)]", "ns::p(1)",
        )) {
            read(text) shouldBe listOf(ASSyntax.parseLiteral(text))
        }
        warnings.shouldBeEmpty()
    }

    test("a percept seen before is the same literal again") {
        check(read("dist(f,1)").single() === read("dist(f,1)").single())
    }

    test("as many readings are known again as a message has, and no more than twice as many of those that went before") {
        for ((percepts, remembered, forgotten) in listOf(
            Triple(12, 100, 200), Triple(1_200, 1_200, 2_500), Triple(1_000_000, 4_000, 5_000),
        )) {
            reader.expect(percepts)
            val first = read("first").single()
            repeat(remembered) { read("p($it)") }
            check(read("first").single() === first) { "forgotten after $remembered others" }
            repeat(forgotten) { read("q($percepts,$it)") }
            check(read("first").single() !== first) { "still known after $forgotten others" }
        }
    }

    test("a percept may not claim a source") {
        read("dist(f,1)[source(bob),q(1)]").single().toString() shouldBe "dist(f,1)[q(1)]"
        read("dist(f,2)[source(self)]").single().toString() shouldBe "dist(f,2)"
    }

    test("what Jason cannot read costs one warning per text, whatever it holds") {
        for (hostile in listOf(
            "dist(f,", "dist f", "1", "\"a\"", "X", ".stopMAS", "argo.act(stop)", "a & b", "p :- q", "\u0000\u001b[2J", "a(b", "é~",
            "3 > 2", "@", "+!go", "[a]", "-",
        )) {
            warnings.clear()
            withClueOf(hostile) {
                read(hostile).shouldBeEmpty()
                read(hostile).shouldBeEmpty()
                warnings shouldHaveSize 1
                warnings.single() shouldNotContain "\u001b"
            }
        }
    }

    test("a variable is not a percept") {
        read("dist(F,3)").shouldBeEmpty()
        read("Room::dist(f,3)").shouldBeEmpty()
        warnings.forEach { it shouldContain "variable" }
        warnings shouldHaveSize 2
    }

    test("a truth value is not a percept, but may be in one") {
        listOf("true", "false", " true ").forEach { read(it).shouldBeEmpty() }
        warnings.map { it.substringAfter(": ") }.distinct() shouldBe
            listOf("true", "false").map { "$it is a word of AgentSpeak, which cannot be a percept's name" }
        read("wall(true)") shouldHaveSize 1
        read("trueNorth(4)") shouldHaveSize 1
    }

    test("a percept with a number that is infinite or none is left out") {
        for (text in listOf("n(1e999)", "n(-1e999)", "n(1/0)", "n(0/0)", "n(1e300*1e300)", "n([1,q(1e999)])", "n(1)[at(1e999)]")) {
            warnings.clear()
            withClueOf(text) {
                read(text).shouldBeEmpty()
                warnings.single() shouldContain "it holds a number that is infinite or none"
            }
        }
        read("n(1.7976931348623157e308,-1e308)") shouldHaveSize 1
    }

    test("a comment is no part of a percept, so a percept with one is left out") {
        listOf("c(1) // dist(f,0)", "c(/* no */ 8)").forEach { read(it).shouldBeEmpty() }
        warnings.forEach { it shouldContain "it holds a comment" }
        warnings shouldHaveSize 2
        read("""url("http://robot/*")""") shouldHaveSize 1
    }

    test("a backslash that begins no escape is named as the cause") {
        read("""path("C:\dir")""").shouldBeEmpty()
        warnings.single() shouldContain "a backslash in it begins no escape"
    }

    test("a percept holds nothing that is computed") {
        for (text in listOf("p(math.random)", "p(1+math.random)", "p(q(r,[1,math.abs(-2)]))", "p[q(math.random(10))]")) {
            read(text).shouldBeEmpty()
        }
        warnings.forEach { it shouldContain "function" }
        warnings shouldHaveSize 4
        read("p(1+1,-2,[3|[4]])[q(-5)]") shouldHaveSize 1
    }

    test("a board cannot claim the state of a port") {
        read("port(ttyACM0,off)").shouldBeEmpty()
        read("port(ttyACM0,off[x])").shouldBeEmpty()
        warnings.forEach { it shouldContain "port" }
        warnings shouldHaveSize 2
        read("port(left,open)") shouldHaveSize 1
    }

    test("a board cannot claim its silence, nor what became of a reflex") {
        read("stale(ttyACM0)").shouldBeEmpty()
        read("reflex(stop,done)").shouldBeEmpty()
        warnings.forEach { it shouldContain "which no board can claim" }
        warnings shouldHaveSize 2
    }

    test("ARGO's own beliefs are those that it makes") {
        OWN_BELIEFS shouldBe mapOf(
            "port/2" to PortStatus.WORDS, "${StaleBeliefs.FUNCTOR}/1" to emptySet(), "${Reflexes.FUNCTOR}/2" to Reflexes.OUTCOMES,
        )
    }

    test("brackets nested ten thousand deep end in a warning") {
        val deep = "a(".repeat(10_000) + "b" + ")".repeat(10_000)
        reader.read(deep).shouldBeEmpty()
        warnings shouldHaveSize 1
        check(warnings.single().length < 1000)
    }

    test("a stray quote that joins two percepts costs what it touches, not what follows") {
        read("say(\"x;light(b,4);y\"").map { it.toString() } shouldBe listOf("light(b,4)")
    }

    test("a board that sends a new broken text each time does not fill the log") {
        repeat(1000) { reader.read("broken($it") }
        check(warnings.size <= 101) { "${warnings.size} warnings" }
        warnings.last() shouldContain "not reported"
    }
})

private fun withClueOf(text: String, test: () -> Unit) = io.kotest.assertions.withClue({ foreignText(text) }, test)
