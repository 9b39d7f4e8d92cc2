package argo.check.syntax

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import jason.asSemantics.Agent
import jason.asSyntax.parser.as2j
import jason.util.Config
import java.io.StringReader
import java.nio.file.FileSystems
import java.nio.file.FileVisitResult
import java.nio.file.Path
import java.util.logging.LogManager
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.visitFileTree
import kotlin.random.Random

class JasonParitySpec : FunSpec({
    beforeSpec {
        Config.get().setProperty(Config.START_WEB_MI, "false") // starts no web server
        LogManager.getLogManager().reset() // hides the warnings of Jason's parser
    }

    fun refusal(text: String): String? = try {
        as2j(StringReader(text)).agent(Agent().apply { initAg() })
        null
    } catch (refused: Throwable) { // a TokenMgrError is an Error
        "$refused"
    }

    /** Skips build folders, since their files change during the test. */
    fun programsBelow(folder: Path): Map<String, String> = buildMap {
        folder.visitFileTree {
            onPreVisitDirectory { one, _ -> if (one.name in BUILDS) FileVisitResult.SKIP_SUBTREE else FileVisitResult.CONTINUE }
            onVisitFile { one, _ -> FileVisitResult.CONTINUE.also { if (one.name.endsWith(".asl")) put("$one", one.readText()) } }
        }
    }

    fun mustReadWhatJasonReads(programs: Map<String, String>) {
        programs.size shouldBeGreaterThan 5
        programs.forEach { (name, text) ->
            val errors = programOf(text).errors
            if (errors.isNotEmpty()) withClue("$name: $errors") { (refusal(text) == null) shouldBe false }
        }
    }

    test("every program of this project is read") {
        val programs = programsBelow(Path.of(".."))
        mustReadWhatJasonReads(programs)
    }

    test("every program in Jason's jar is read") {
        val jar = Path.of(Agent::class.java.protectionDomain.codeSource.location.toURI())
        FileSystems.newFileSystem(jar).use { mustReadWhatJasonReads(programsBelow(it.getPath("/"))) }
    }

    test("every program of a corpus that Jason reads is read").config(enabled = CORPUS != null) {
        mustReadWhatJasonReads(programsBelow(Path.of(CORPUS!!)))
    }

    test("made programs that Jason reads are read") {
        val part = Arb.element(
            "+!g(X)", "-b", "^!g", " : ", " <- ", "a", "X", "_", ".", "p(X,1)", ".print(X)", "[a|T]", "[1,b]", "(", ")", " & ", " | ",
            "not ", ";",
            " |&| ", "|||", "?q", "!g", "!!g", "+b", "-+b(1)", "++b", "--b", "+<b", "{ +!g <- b }", "{ a; b }", "{ +a }", "{", "}",
            "if (a) ", "{ b }",
            " else ", " elif (c) ", "for (a) ", "while (X < 3) ", "X = 3 + 2 * Y", "=..", "\"s\"", "ns::", "~", "[source(A)]", "@l", ":-",
            "**", " div ", "-",
            ".\n", "true", "begin", "'q r'", ".5", "1.5e3", "_1", "<: ", ",", "{ end }", "{ begin namespace(x) }", "X > Y", "\\==",
            "/* c */",
        )
        var accepted = 0
        checkAll(20 * PropertyTesting.defaultIterationCount, Arb.list(part, 1..7)) { parts ->
            val text = parts.joinToString("") + "."
            val errors = programOf(text).errors
            if (errors.isNotEmpty()) withClue("$text: $errors") { (refusal(text) == null) shouldBe false } else accepted++
        }
        accepted shouldBeGreaterThan 100
    }

    test("a program with a slip that Jason refuses is refused") {
        val random = Random(SEED)
        val programs = (CORPUS?.let { programsBelow(Path.of(it)) } ?: programsBelow(Path.of(".."))).values
            .filter { refusal(it) == null && "include" !in it }.map(::programOf)
        val others =
            listOf("(", ")", "[", "]", "{", "}", ".", ",", ";", ":", "<-", "+", "!", "?", "&", "|", "not", "a", "X", "1", "\"s\"", "@")
        var agreed = 0
        val wrong = ArrayList<String>()
        repeat(SLIPS) {
            val program = programs.random(random)
            val tokens = program.tokens.filter { it.kind != TokenKind.COMMENT }
            val token = tokens.randomOrNull(random) ?: return@repeat
            val text = when (random.nextInt(3)) {
                0 -> program.text.removeRange(token.span.start, token.span.end)
                1 -> program.text.replaceRange(token.span.start, token.span.end, others.random(random))
                else -> program.text.replaceRange(token.span.start, token.span.start, others.random(random) + " ")
            }
            val jason = refusal(text)
            if ((jason == null) == programOf(text).errors.isEmpty()) agreed++
            else wrong += "${program.lines.text(program.lines.position(token.span.start).line)} at $token: Jason $jason, " +
                "here ${programOf(text).errors}"
        }
        println("slips in ${programs.size} programs: $agreed judged alike, ${wrong.size} otherwise")
        wrong.forEach(::println)
        wrong.size * 1000 shouldBeLessThanOrEqual MOST_IN_1000 * (agreed + wrong.size)
    }

    test("what Jason refuses for its form is mostly refused") {
        listOf("a(.", "+!a <- .", "a b.", "+!a <- b; ; c.", "[a].", "+!a : .", "a :- .", "+ <- b.", "+!a <- (b.", "!X", "a()",
            "+!a <- x[.").forEach { text ->
            withClue(text) {
                (refusal(text) == null) shouldBe false
                programOf(text).errors.isEmpty() shouldBe false
            }
        }
        programOf("a. b(1).").errors.shouldBeEmpty()
    }
})

private const val SEED = 31
private const val SLIPS = 2_000

/** The accepted number of disagreements in 1,000 texts. Jason's parser finds some errors only by loading classes. */
private const val MOST_IN_1000 = 5

private val BUILDS = setOf("target", "build")

/** A folder with more programs to test, or null. `-DargLine=-Dargo.corpus=…` names it. */
private val CORPUS: String? = System.getProperty("argo.corpus")
