package argo.filters.matching

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class UnreadablePerceptsSpec : FunSpec({
    listOf(
        "stop", "dist(front,30)", "~wall", "say(\"Hi (there\")", "at([1,2],p(q))", "wall(true)", "t(-3.5)[level(2)]", "p('Front Left')",
        "'Öl'(\"grün\")",
    ).forEach {
        test("$it can be read") { whyUnreadable(it) shouldBe null }
    }

    mapOf(
        "Dist(30)" to "its name begins in upper case, so it is a variable; write dist(30)",
        "_x" to "its name begins with _, so it is a variable; write x",
        "_(1)" to "its name begins with _, so it is a variable; write a name that begins with one of a to z",
        "_1(2)" to "its name begins with _, so it is a variable; write a name that begins with one of a to z",
        "Dist(X)" to "its name begins in upper case, so it is a variable; write a name that begins with one of a to z",
        "Öl(1)" to "Ö is no letter of a word, which a to z are; put the word in quotes",
        "light(grün)" to "ü is no letter of a word, which a to z are; put the word in quotes",
        "t(kitchen,21,5" to "a bracket or a quote is not closed",
        "say(\"x)" to "a bracket or a quote is not closed",
        "dist(Front,3)" to "a word in it begins in upper case, so it is a variable; write it in lower case or in quotes",
        "say(\"a\nb\")" to "there is a line break in quotes; write \\n",
        "for(1)" to "for is a word of AgentSpeak, which cannot be a percept's name",
        "true" to "true is a word of AgentSpeak, which cannot be a percept's name",
        "n([1,q(1e999)])" to "it holds a number that is infinite or none",
        "30" to "it is no literal",
        "front left" to "it is no literal",
        "" to "it is empty",
    ).forEach { (percept, why) ->
        test("\"$percept\" cannot be read, with what to write") { whyUnreadable(percept).orEmpty() shouldContain why }
    }

    listOf("1(\"${"a".repeat(60_000)}\")", "1(\"${"\\\\".repeat(30_000)}\")", "1('${"a".repeat(60_000)}')").forEach {
        test("${it.take(6)}… of ${it.length} characters is told of too") { whyUnreadable(it).orEmpty() shouldContain "it is no literal" }
    }
})
