package argo.lsp.agents

import argo.check.syntax.Token
import argo.check.syntax.programOf
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.readText
import kotlin.io.path.walk

private fun laidOut(text: String): String =
    formattingOf(programOf(text)).foldRight(StringBuilder(text)) { blanks, result ->
        result.replace(blanks.span.start, blanks.span.end, blanks.text)
    }.toString()

class FormattingSpec : FunSpec({
    val samples = Path.of("../samples").walk().filter { it.extension == "asl" && "target" !in "$it" }.map { it.readText() }.toList()

    test("blanks, indentation and the end of the text") {
        laidOut("!a .\n  b( 1,2 ,3 ).\n+!g:x&y<-\nc;  \n  .print( \"a ; b\" ).\n\n\n+!h\n  <- a;\n  b.   ") shouldBe
            "!a .\nb(1, 2, 3).\n+!g : x & y <-\n    c;\n    .print(\"a ; b\").\n\n\n+!h\n    <- a;\n       b.\n"
    }

    test("blocks in braces are indented, and alignment by blanks and comments stays") {
        laidOut("+!a   <- if (x) {\nb; // why\n} else {\n    c   }.   // c\n/* one\n  two */\n") shouldBe
            "+!a   <- if (x) {\n        b; // why\n    } else {\n        c   }.   // c\n/* one\n  two */\n"
    }

    test("a plan with an error stays as it is, and the others are laid out") {
        laidOut("+!a <- b( .\n+!c<-d( 1 ).\n") shouldBe "+!a <- b( .\n+!c <- d(1).\n"
    }

    test("the samples stay as they are, but for blanks in front of an end") {
        samples.forEach { text -> withClue(text) { words(laidOut(text)) shouldBe words(text) } }
    }

    test("any text keeps its tokens, and is laid out once and for all") {
        val gap = Arb.element("", " ", "  ", "\n", "\n\n", "\t", "\r\n", " // c\n", "/* c\n */")
        val torn = arbitrary { source ->
            val tokens = programOf(samples[source.random.nextInt(samples.size)]).tokens
            val from = source.random.nextInt(tokens.size)
            tokens.subList(from, (from + 60).coerceAtMost(tokens.size)).joinToString("") { it.text + gap.sample(source).value }
        }
        checkAll(torn, Arb.list(Arb.int(0..1_000), 0..3)) { text, cuts ->
            val cut = cuts.fold(text) { it, at -> if (it.isEmpty()) it else it.removeRange(at % it.length, at % it.length + 1) }
            val once = laidOut(cut)
            words(once) shouldBe words(cut)
            once.filterNot(Char::isWhitespace) shouldBe cut.filterNot(Char::isWhitespace)
            if (programOf(once).errors.isEmpty()) laidOut(once) shouldBe once
        }
    }
})

private fun words(text: String) = programOf(text).tokens.map(Token::text)
