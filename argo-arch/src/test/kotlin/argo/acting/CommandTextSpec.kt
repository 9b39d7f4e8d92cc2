package argo.acting

import argo.calls.ArgumentException
import argo.filters.jason.PerceptReader
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.arbitrary.of
import io.kotest.property.checkAll
import jason.asSyntax.ASSyntax
import jason.asSyntax.Atom
import jason.asSyntax.Literal
import jason.asSyntax.Term

/** Generates terms as in plans, up to [depth] levels deep. */
private fun terms(depth: Int): Arb<Term> = Arb.int(0..(if (depth == 0) 5 else 8)).let { kinds ->
    Arb.bind(kinds, Arb.int(), Arb.numericDouble(-1e6, 1e6), Arb.of("a", "front", "a b(", "")) { kind, whole, number, word ->
        when (kind) {
            0 -> ASSyntax.createNumber(whole.toDouble())
            1 -> ASSyntax.createNumber(number)
            2 -> ASSyntax.createString(word)
            3 -> ASSyntax.parseTerm("[1,b|[c]]")
            4 -> ASSyntax.parseTerm("near[distance(3)]")
            5 -> ASSyntax.parseTerm("1+2")
            6 -> ASSyntax.parseLiteral("~far")
            7 -> ASSyntax.parseLiteral("other::part(1)")
            else -> ASSyntax.createAtom("left")
        }
    }
}

private val structures: Arb<Literal> = Arb.bind(
    Arb.list(terms(2), 0..4), Arb.list(terms(1), 1..2), Arb.boolean(),
) { terms, inner, positive ->
    ASSyntax.createLiteral(positive, "speed", *terms.toTypedArray(), ASSyntax.createStructure("of", *inner.toTypedArray()))
}

private fun lineText(command: Term): String = commandText(command.also(::requireCommand), isLine = true)

class CommandTextSpec : FunSpec({
    test("a literal is sent as Jason writes it") {
        checkAll(structures) { lineText(it) shouldBe it.toString() }
    }

    test("an atom, a negated literal and one with annotations are sent as Jason writes them") {
        for (text in listOf("stop", "~stop", "stop[soon]", "speed(1)[a,b(2)]", "speed(\"a\",-1.5,[b])")) {
            lineText(ASSyntax.parseLiteral(text)) shouldBe ASSyntax.parseLiteral(text).toString()
        }
    }

    test("a command with a number that is infinite or none is refused") {
        for (number in listOf(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NaN)) {
            val one = ASSyntax.createNumber(number)
            for (held in listOf(one, ASSyntax.createList(one), ASSyntax.createStructure("of", one))) {
                shouldThrow<ArgumentException> { requireCommand(ASSyntax.createLiteral("n", held)) }.message shouldContain "a division by 0"
            }
        }
    }

    test("a literal is sent without its namespace, and its arguments with theirs") {
        checkAll(structures) { literal ->
            lineText(literal.cloneNS(Atom("left")) as Literal) shouldBe (literal.cloneNS(Literal.DefaultNS) as Literal).toString()
        }
        lineText(ASSyntax.parseLiteral("left::stop[soon]")) shouldBe "stop[soon]"
    }

    test("a quote in a string is sent with a backslash, so that it does not end the string for the board") {
        val text = ASSyntax.createString("\",9,\"")
        lineText(ASSyntax.createLiteral("say", text)) shouldBe """say("\",9,\"")"""
        lineText(ASSyntax.parseLiteral("""say(["a\"b"],c("d\"e"))[f("g\"h")]""")) shouldBe """say(["a\"b"],c("d\"e"))[f("g\"h")]"""
    }

    test("the two backslashes that Jason reads from a program stay two, which a board reads as one; one from elsewhere is escaped") {
        lineText(ASSyntax.parseLiteral("""say("C:\\maps")""")) shouldBe """say("C:\\maps")"""
        lineText(ASSyntax.createLiteral("say", ASSyntax.createString("C:\\"))) shouldBe """say("C:\\")"""
    }

    test("a string is sent without its quotes") {
        lineText(ASSyntax.createString("left::raw text")) shouldBe "left::raw text"
    }

    test("what is no command is refused with what was found") {
        for (term in listOf("3", "[a]", "X", "speed(X)", "\"\"", "getPercepts", "getPercepts(dist)")) {
            shouldThrow<ArgumentException> { lineText(ASSyntax.parseTerm(term)) }
        }
        shouldThrow<ArgumentException> { lineText(ASSyntax.createString("a€")) }.message shouldContain "one byte per character"
        shouldThrow<ArgumentException> { lineText(ASSyntax.parseTerm("speed(X)")) }.message shouldContain "speed(X)"
    }

    test("a link that reads commands back gets their strings with escapes, and characters that no line carries") {
        for (text in listOf("☃", "C:\\maps", "say \"hi\"", "two\nlines", "x".repeat(1_000))) {
            val command = ASSyntax.createLiteral("say", ASSyntax.createString(text))
            PerceptReader.read(commandText(command.cloneNS(Atom("left")), isLine = false)) shouldBe command
        }
        commandText(ASSyntax.createString("say(☃)"), isLine = false) shouldBe "say(☃)"
    }
})
