package argo.filters.matching

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class PerceptMessageSpec : FunSpec({
    test("percepts are separated by semicolons, the last one may lack its own") {
        perceptsOf("dist(f,123);light(b,40);") shouldBe listOf("dist(f,123)", "light(b,40)")
        perceptsOf("dist(f,123);light(b,40)") shouldBe listOf("dist(f,123)", "light(b,40)")
    }

    test("white space and empty pieces around percepts do not count") {
        perceptsOf(" ;; a ;\r\n b;") shouldBe listOf("a", "b")
        perceptsOf("") shouldBe emptyList()
    }

    test("a semicolon inside a string, a quoted atom or brackets does not separate") {
        perceptsOf("""say("hi; you");b;""") shouldBe listOf("""say("hi; you")""", "b")
        perceptsOf("""say("a\";b");c""") shouldBe listOf("""say("a\";b")""", "c")
        perceptsOf("""drive('C:\');b(')');c;""") shouldBe listOf("""drive('C:\')""", "b(')')", "c")
        perceptsOf("l([a;b]);p(x)[q(1;2)];z") shouldBe listOf("l([a;b])", "p(x)[q(1;2)]", "z")
    }

    test("a percept whose brackets or quotes do not match costs itself and not the ones after it") {
        perceptsOf("open(;dist(f,3);light(b,4);") shouldBe listOf("open(", "dist(f,3)", "light(b,4)")
        perceptsOf("""say("x);dist(f,3);""") shouldContain "dist(f,3)"
        perceptsOf("a);b;") shouldBe listOf("a)", "b")
        perceptsOf("a(];b(1);") shouldBe listOf("a(]", "b(1)")
    }

    test("percepts of any well-formed kind come out as they went in") {
        val percept = Arb.element("a", "b(1)", "~c(x)", "d(\"x;y\")", "e([1,2;3],f(g))", "h(1)[q(0.5);r]", "i('\\')", "j(';(')")
        checkAll(Arb.list(percept, 0..12)) { percepts ->
            perceptsOf(percepts.joinToString("") { "$it;" }) shouldBe percepts
        }
    }

    test("no text is too much for it, and nothing but white space and semicolons is lost") {
        fun essence(text: String) = text.filterNot { it == ';' || it.isWhitespace() }
        checkAll(Arb.string(0..255)) { text ->
            val percepts = perceptsOf(text)
            percepts.forEach { check(it.isNotEmpty()) }
            essence(percepts.joinToString("")) shouldBe essence(text)
        }
        perceptsOf("(".repeat(10_000) + ";a;").last() shouldBe "a"
    }
})
