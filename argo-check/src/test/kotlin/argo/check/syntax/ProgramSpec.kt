package argo.check.syntax

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import io.kotest.property.Arb
import io.kotest.property.arbitrary.Codepoint
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.of
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class ProgramSpec : FunSpec({
    fun plan(text: String) = programOf(text).also { withClue(text) { it.errors.shouldBeEmpty() } }.components.single() as Plan
    fun errors(text: String) = programOf(text).run { errors.map { "${lines.position(it.span.start)} ${it.message}" } }

    test("a plan has its label, event, context, body and inner plans") {
        val plan = plan("@p1[atomic] +!go(X)[source(self)] : near(X) & not busy <: done <- move(X); !!next; -+at(X). { +b <- c. }")
        plan.label?.name?.text shouldBe "p1"
        plan.trigger.kind shouldBe EventKind.ACHIEVE
        (plan.trigger.term as Literal).indicator shouldBe "go/1"
        plan.context.shouldBeInstanceOf<Operation>().isOf("&") shouldBe true
        plan.goalCondition.shouldBeInstanceOf<Literal>().functor shouldBe "done"
        plan.body.shouldNotBeNull().statements.map { (it as Formula).operator } shouldContainExactly
            listOf(BodyOperator.DO, BodyOperator.ACHIEVE_APART, BodyOperator.REPLACE)
        plan.plans.single().trigger.kind shouldBe EventKind.BELIEF
    }

    test("a term in braces is a body, a plan, an event or a rule") {
        fun content(term: String) = programOf("+!a <- .x($term).").nodes().filterIsInstance<Block>().first().content
        content("{ +a; !b }").shouldBeInstanceOf<Body>().statements.map { (it as Formula).operator } shouldContainExactly
            listOf(BodyOperator.ADD, BodyOperator.ACHIEVE)
        content("{ +!a }").shouldBeInstanceOf<Trigger>()
        content("{ @l +!a <- b }").shouldBeInstanceOf<Plan>().label?.name?.text shouldBe "l"
        content("{ p(X) :- q(X) & X > 2 }").shouldBeInstanceOf<Belief>()
        content("{ }").shouldBeInstanceOf<Body>().statements.shouldBeEmpty()
    }

    test("a name with a dot is an internal action, one in quotes is none") {
        val literals = programOf("+!a <- .print(1); my.act(2); 'x.y'(3); z(1.5).").nodes().filterIsInstance<Literal>()
        literals.filter { it.isInternal }.map { it.indicator }.toList() shouldContainExactly listOf(".print/1", "my.act/1")
        literals.first { it.functor == "x.y" }.arity shouldBe 1
    }

    context("a text that Jason refuses has one error at its place") {
        listOf(
            "+!a <- b(.\n+!c <- d." to "1:10 here should be a term, not .",
            "+!a <- b\n+!c <- d." to "1:8 a full stop is missing behind b",
            "+!a <- b c." to "1:10 here should be a full stop, not c",
            "+!a : x & <- b." to "1:11 here should be a term, not <-",
            "+!a <- .print(\"oops).\n+!c <- d." to "1:15 this string has no end",
            "+!a <- if (x) { b }  else c." to "1:27 here should be {, not c",
            "temp\u00e9rature(3)." to "1:1 the name temp\u00e9rature has the letter \u00e9",
            "a(1).\n\u0000b." to "2:1 Jason reads no character U+0000 here",
            "X." to "1:1 a belief is no variable, as X is",
            "+!a <- ! .print(1)." to "1:10 .print is an internal action",
            "+!a <- ?.date(Y,M,D)." to "1:9 .date is an internal action",
            "+!a <- " to "1:5 the text ends where a statement should be",
            "/* no end" to "1:1 this comment has no end",
            "+!a <- .print(\"\\d\")." to "1:16 Jason knows no \\d in a string",
            "a :- b" to "1:6 the text ends where a full stop should be",
        ).forEach { (text, error) ->
            test(text) { withClue(errors(text)) { errors(text).firstOrNull()?.take(error.length) shouldBe error } }
        }
    }

    test("behind an error the next plan is read") {
        val program = programOf("+!a <- b(.\n+!c <- d.\n+!e <- f(1) g(2);\n  h.\n@l +!i <- j.\nk(1)\n+!m <- n.\n+!o <- p.")
        val goals = program.components.filterIsInstance<Plan>().map { (it.trigger.term as Named).name.text }
        goals.filter { it != "b" } shouldContainExactly listOf("a", "c", "e", "i", "m", "o")
        program.errors.map { program.lines.position(it.span.start).line } shouldContainExactly listOf(1, 3, 6)
    }

    test("a cursor finds the nodes and the token that it touches") {
        val text = "+!go : near(Wall) <- argo.act(stop)."
        val program = programOf(text)
        (program.nodesAt(text.indexOf("Wall") + 2).last() as Name).text shouldBe "Wall"
        program.nodesAt(text.indexOf("stop")).filterIsInstance<Literal>().map { it.functor } shouldContainExactly listOf("argo.act", "stop")
        program.tokenAt(text.indexOf("argo") + 3)?.text shouldBe "argo.act"
        program.tokenAt(0)?.text shouldBe "+"
    }

    test("offsets and positions are converted for each kind of line end") {
        val text = "ab\r\ncd\ref\n"
        val lines = Lines(text)
        lines.count shouldBe 4
        (0..text.length).filter { text.getOrNull(it) != '\n' || text[it - 1] != '\r' }.forEach {
            lines.offset(lines.position(it)) shouldBe it
        }
        lines.position(4) shouldBe Position(2, 1)
        lines.text(2) shouldBe "cd"
        lines.offset(Position(9, 1)) shouldBe text.length
    }

    test("a text that nests too deep is refused, and the next plan is read") {
        listOf("(", "[", "f(", "{", "-(", "[a|").forEach { opening ->
            val program = programOf("+!a <- x(${opening.repeat(100_000)}).\n+!b <- c.")
            program.errors.first().message shouldBe "this is nested more than 100 deep"
            (program.components.last() as Plan).trigger.term.toString() shouldBe "b/0"
        }
        programOf("{ begin namespace(a) }\n".repeat(10_000)).errors.first().message shouldBe "this is nested more than 100 deep"
    }

    test("any text gives a tree and tokens that cover it") {
        val part = Arb.element(
            "+", "-", "!", "?", "a", "X", "_", ".", ".b", "1", "1.5", "(", ")", "[", "]", "{", "}", "|", "&", "|&|", "|||", ";", ",", ":",
            "<-", ":-", "::", "~", "@", "^", "not ", "if ", "else ", "elif ", "for ", "while ", "{ begin x }", "{ end }", "true", "\"s\"",
            "\"", "'", "/*", "*/", "//", "\n", "\n+!", " ", "\\", "=..", "\u00e9", "\uD83D\uDE00", "\u0000", "<", "\t",
        )
        val texts = Arb.choice(Arb.list(part, 0..60).map { it.joinToString("") }, Arb.string(0..80, characters))
        checkAll(texts, Arb.int(0..100)) { text, at ->
            val program = programOf(text)
            var end = 0
            program.tokens.forEach { token ->
                text.substring(end, token.span.start).shouldBeBlank()
                text.substring(token.span.start, token.span.end) shouldBe token.text
                end = token.span.end
            }
            text.substring(end).shouldBeBlank()
            program.errors.forEach { it.span.end.shouldBeInRange(it.span.start..text.length) }
            program.nodes().forEach { node ->
                node.span.start.shouldBeInRange(0..node.span.end)
                node.span.end shouldBeLessThanOrEqual text.length
            }
            program.nodesAt(at.coerceAtMost(text.length))
            program.tokenAt(at.coerceAtMost(text.length))
        }
    }
})

private val characters = Arb.of((' '.code..'~'.code).map(::Codepoint) + Codepoint(10) + Codepoint(0xe4))

private fun String.shouldBeBlank() = withClue(this) { all { it in " \t\n\r" } shouldBe true }
