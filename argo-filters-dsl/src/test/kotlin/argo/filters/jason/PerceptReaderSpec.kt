package argo.filters.jason

import argo.filters.DecimalReader
import argo.filters.GroundTerm
import argo.filters.perceptTexts
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll
import jason.asSyntax.ASSyntax
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.StringTermImpl
import jason.asSyntax.Structure
import jason.asSyntax.Term

private fun anatomy(term: Term): String = buildString {
    append(term.javaClass.name).append('«').append(term).append('»').append(term.hashCode())
    append('@').append(term.srcInfo?.let { "${it.srcFile}:${it.beginSrcLine}-${it.endSrcLine}" })
    append(listOf(
        term.isAtom, term.isLiteral, term.isStructure, term.isList, term.isString, term.isNumeric, term.isArithExpr, term.isGround,
        term.isPred, term.isVar,
    ))
    if (term is Literal) append(term.ns).append(term.negated()).append(term.predicateIndicator).append(term.canBeAddedInBB())
    when {
        term.isVar -> Unit
        term is ListTerm -> term.forEach { append(anatomy(it)) }
        term is Structure -> (0 until term.arity).forEach { append(anatomy(term.getTerm(it))) }
    }
    if (term is Literal && !term.isVar && term !is ListTerm && term.hasAnnot()) append(anatomy(term.annots))
}

private fun shouldReadAsJason(text: String) = withClue(text) {
    val expected = ASSyntax.parseLiteral(text)
    val found = PerceptReader.read(text)
    anatomy(found) shouldBe anatomy(expected)
    // in Jason, two readings of one text may differ: [-1] is an expression, and the order of annotations counts
    val again = ASSyntax.parseLiteral(text)
    (found == expected) shouldBe (again == expected)
    (expected == found) shouldBe (expected == again)
}

class PerceptReaderSpec : StringSpec({
    val count = PropertyTesting.defaultIterationCount // 1,000, or fewer in a short run

    "it reads every percept exactly as Jason's parser does" {
        var fast = 0
        checkAll(10 * count, perceptTexts) {
            shouldReadAsJason(it)
            if (FastLiteralParser(it).parse() != null) fast++
        }
        fast shouldBeGreaterThan count
    }

    "it reads what boards send without Jason's parser, and exactly as it does" {
        val texts = listOf(
            "dist(f,123)", "light(b,40)", "open", "~open(door)", "temp(left,-5)", "temp(left,- 5.25)", "gps(-22.9,-43.2,1e3)", "d(0)",
            "d(007)", "d(0.10)", "d(123456789012345678)", "d(1.5e-7)",
            "say(\"hi; you\")", "say(\"a \\\"b\\\" \\n c\\\\ \")", "pos(p(1,2),[a,b(3),\"c\",[]])", "'Left wheel'(1)",
            "d(f,3)[q(0.5),source(x),a,\"s\",3]", "d [ b , a ]", " d( f , 3 ) ",
            "d(~a)", "d(a[x])", "begin", "end(1)", "d(begin)", "d(source(x),self,percept)", "d[]", "d([])",
            "d(é_in_string(\"é漢\uD83D\uDE00\"))".replace("é_in", "e_in"), "abs(1)", "d(x_Y1)", "d(true,[false])", "d( false )",
        )
        for (text in texts) {
            withClue(text) { FastLiteralParser(text).parse() shouldNotBe null }
            shouldReadAsJason(text)
        }
    }

    "it leaves the rest to Jason's parser" {
        val texts = listOf(
            "house::dist(1)", "default::d", "true", "false", "d(true,default,this_ns)", "d(X)", "d(1+2)", "d(+1)", "d(.5)", "d((a))",
            "d(-(5))", "d([a|[b]])", "d([H|T])", "d(a & b)", "d(not a)",
            "d({+!g})", "d(\n1)", "d(1) // comment", "d(/* c */1)", "d(house::a)", "d(math.abs(-1))", "X", "d(1)[a|[b]]",
        )
        for (text in texts) {
            withClue(text) { FastLiteralParser(text).parse() shouldBe null }
            shouldReadAsJason(text)
        }
    }

    "it reads strings that Jason's syntax cannot hold" {
        for (text in listOf("C:\\robot\\map.yaml", "\\d+", "a\\nb", "\\", "a\rb", "say \"\\\"")) {
            val literal = PerceptReader.read("map(true,${GroundTerm.Text(text)})")
            literal shouldBe ASSyntax.createLiteral("map", Literal.LTrue, StringTermImpl(text))
            PerceptReader.read(perceptText(literal)) shouldBe literal
        }
    }

    "it reads every number to the same double" {
        checkAll(5 * count, Arb.numericDouble()) { shouldReadAsJason("d(${it.toBigDecimal().toPlainString()},$it)") }
        checkAll(5 * count, Arb.list(Arb.element("0", "1", "9", "5", "."), 1..18).map { it.joinToString("") }) { text ->
            val value = DecimalReader.plain(text, 0, text.length)
            if (!value.isNaN()) value shouldBe text.toDouble()
        }
    }

    "it refuses exactly what Jason's parser refuses" {
        val tokens = Arb.list(Arb.element(
            "d", "(", ")", "[", "]", ",", "|", "\"", "'", "\\", "~", ":", ".", "-", "+", "1", "1.5e", "X", " ", "\n", "/", "true", "not",
            "a", "é", "&", "_9999999999", "{", "}", "!", ";", "<", "=", "*",
        ), 0..10)
        checkAll(20 * count, tokens.map { it.joinToString("") }) { text ->
            val expected = try { ASSyntax.parseLiteral(text) } catch (_: Exception) { null } catch (_: Error) { null }
            if (expected == null) {
                withClue(text) { shouldThrow<PerceptSyntaxException> { PerceptReader.read(text) } }
            } else {
                shouldReadAsJason(text)
            }
        }
    }

    "what is no literal is refused with its text and the cause" {
        shouldThrow<PerceptSyntaxException> { PerceptReader.read("dist(f 3)") }.message shouldContain
            "'dist(f 3)' is not a literal that Jason can read: "
        fun refusal(text: String) = shouldThrow<PerceptSyntaxException> { PerceptReader.read(text) }.message!!
        refusal("x".repeat(500) + "(").length shouldBe refusal("x".repeat(501) + "(").length
        refusal("dist(\u001b[2J") shouldContain "'dist(\\x1B[2J'"
    }

    "a decimal comma makes two arguments" {
        PerceptReader.read("temp(21,5)").arity shouldBe 2
        PerceptReader.read("temp(21.5)").arity shouldBe 1
    }

    "nesting without end is refused, not a stack overflow" {
        val nested = "d(" + "(".repeat(100_000) + "1" + ")".repeat(100_000) + ")"
        shouldThrow<PerceptSyntaxException> { PerceptReader.read(nested) }.message shouldContain "nested too deep"
        shouldThrow<PerceptSyntaxException> { PerceptReader.read("d(" + "[".repeat(100_000)) }
    }
})
