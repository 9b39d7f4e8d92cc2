package argo.recording.agent

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Atom
import jason.asSyntax.CyclicTerm
import jason.asSyntax.Literal
import jason.asSyntax.LiteralImpl
import jason.asSyntax.NumberTermImpl
import jason.asSyntax.ObjectTermImpl
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.StringTermImpl
import jason.asSyntax.Structure
import jason.asSyntax.Term
import jason.asSyntax.UnnamedVar
import jason.asSyntax.VarTerm

class TermTextSpec : FunSpec({
    fun shouldReturn(term: Term) {
        val text = textOf(term)
        withClue("$term, written $text") { differences(term, termOf(text)).shouldBeEmpty() }
    }

    test("each term that Jason has") {
        checkAll(3 * PropertyTesting.defaultIterationCount, Arb.terms()) { shouldReturn(it) }
    }

    test("a percept or belief, where one word is a literal") {
        checkAll(Arb.literals()) { literal ->
            val text = literalText(literal)
            withClue("$literal, written $text") { differences(literal, literalOf(text)).shouldBeEmpty() }
        }
    }

    for ((number, text) in mapOf(
        -1.0 to "-1", 0.0 to "0", -0.0 to "-0.0", 2.5 to "2.5", 1e300 to "1.0E300", Double.NaN to "#NaN",
        Double.NEGATIVE_INFINITY to "#-Infinity", 9007199254740993.0 to "9.007199254740992E15",
    )) {
        test("the number $text") {
            textOf(NumberTermImpl(number)) shouldBe text
            (termOf(text) as NumberTermImpl).solve().toRawBits() shouldBe number.toRawBits()
        }
    }

    test("a negative number is no expression, and an expression is no number") {
        termOf("temp(-1)") shouldBe ASSyntax.createLiteral("temp", ASSyntax.createNumber(-1.0))
        textOf(ASSyntax.parseTerm("-1")) shouldBe "(-1)"
        shouldReturn(ASSyntax.parseTerm("f((-1),X-1,(2-(-3)),-(-1))"))
    }

    test("an atom of any text") {
        textOf(Atom("Upper Case")) shouldBe "#\"Upper Case\""
        for (text in listOf("Upper Case", "", "true", "not", "a.b", "default", "it's", "'quoted one'", "\uD800", "ação", "#x", "_x", "1")) {
            shouldReturn(Atom(text))
            shouldReturn(LiteralImpl(text))
            shouldReturn(Structure(text).addTerms(Atom(text)))
        }
    }

    test("an atom is no literal without arguments") {
        textOf(LiteralImpl("hello")) shouldBe "hello()"
        literalText(LiteralImpl("hello")) shouldBe "hello"
        literalText(Atom("hello")) shouldBe "#atom(hello)" // Jason does not believe an atom
    }

    test("a variable keeps the number that Jason gave it, and reading gives out none") {
        val variable = UnnamedVar()
        val text = textOf(variable)
        text shouldBe "_${variable.myId}"
        (termOf(text) as UnnamedVar).myId shouldBe variable.myId
        (termOf("_77") as UnnamedVar).myId shouldBe 77
        UnnamedVar().myId shouldBe variable.myId + 1
        shouldReturn(ASSyntax.parseTerm("_34"))
        shouldReturn(VarTerm("_34"))
    }

    test("parts of programs, with the lines in which they stand") {
        val plan = ASSyntax.parsePlan(
            "@l[atomic] +!go(X,_)[source(S)] : not a(X) & (b | X > 2) & .random(R) & .count(d(_),N) " +
                "<- .print(\"a \\\"b\\\"\", X); !!h; -+c(X-1); ?e; act(~f); X = math.max(1,X); .add_plan({ +!i <- j }); .wait(10).",
        )
        plan.setAsPlanTerm(true)
        shouldReturn(plan)
        shouldReturn(ASSyntax.parseTerm("[{ +!g : c <- b }, { -?g(X)[s] }, { a; !b(X); +c }, { }, { a(X) :- b(X) & not c | d(X+1) }]"))
    }

    test("a step that compares keeps its line when Jason copies it, also if its variables have lost theirs") {
        val plan = ASSyntax.parsePlan("+!go(X)\n <- Y = X + 20;\n X < 30.").apply { makeVarsAnnon() }
        fun lines(body: PlanBody) = generateSequence(body) { it.bodyNext }.map { it.capply(Unifier()).srcInfo?.beginSrcLine }.toList()
        lines((termOf(textOf(plan)) as Plan).body) shouldBe lines(plan.body)
        lines(plan.body) shouldBe listOf(2, 3)
    }

    test("a term that cannot be recorded is refused by its name") {
        val terms = listOf<Pair<Term, String>>(
            Structure("f").addTerms(ObjectTermImpl(java.util.Date())) to "a Java object of the class java.util.Date",
            CyclicTerm(LiteralImpl("f"), VarTerm("X")) to "a term that holds itself",
            (1..100_000).fold<Int, Term>(Atom("a")) { inner, _ -> Structure("f", 1).apply { addTerm(inner) } } to "nested too deep",
        )
        for ((term, why) in terms) {
            val refused = runCatching { termOf(textOf(term)) }.exceptionOrNull()
            (refused as UnrecordableTerm).message shouldContain why
        }
    }

    test("what recordings of format 1 hold") {
        "${termOf("temp((-1))")}" shouldBe "temp((-1))"
        "${termOf("get(_Id,\"a \\\"b\\\"\",[x|T])")}" shouldContain "\"a \"b\"\",[x|T])"
        (termOf("note(\"C:\\temp\")") as Literal).getTerm(0) shouldBe StringTermImpl("C:\\temp")
    }

    test("a message whose content Jason reads when it is taken") {
        val agent = jason.asSemantics.Agent()
        contentOf(contentText("price(-1)"), agent) shouldBe "price(-1)"
        contentOf(contentText("a \"text\" \\ of\nlines"), agent) shouldBe "a \"text\" \\ of\nlines"
    }

    test("a text that is no content, as another program may send it, is refused as such, and shown up to 200 characters") {
        val agent = jason.asSemantics.Agent()
        for (text in listOf("#text(", "#text(abc)", "#map(a)", "#event(1,foo,bar,#none,x)", "#fun()", "#set(", "")) {
            withClue(text) { shouldThrow<IllegalArgumentException> { contentOf(text, agent) } }
        }
        shouldThrow<IllegalArgumentException> { contentOf("x(\"" + "y".repeat(1000), agent) }.message shouldBe
            "Jason cannot read \"x(\"${"y".repeat(197)}…\""
        val signs = Arb.element("", "(", ")", "#", "\"", ",", "1", "_", "[", "|", "::", ".", "\\")
        val texts = Arb.terms().map { textOf(it) }
        checkAll(2 * PropertyTesting.defaultIterationCount, texts, Arb.int(0..1000), signs) { written, place, sign ->
            val text = written.replaceRange(place % written.length, place % written.length + 1, sign)
            val failure = runCatching { contentOf(text, agent) }.exceptionOrNull()
            withClue("$text: $failure") { (failure == null || failure is IllegalArgumentException) shouldBe true }
        }
    }
})
