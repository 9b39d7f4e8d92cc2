package argo.lsp.agents

import argo.lsp.Editor
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.eclipse.lsp4j.Location
import java.util.concurrent.ExecutionException
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteExisting
import kotlin.io.path.writeText

/** In the texts of these tests, a `§` is the cursor. */
class AgentLanguageSpec : FunSpec({
    val project = tempdir().toPath()
    val uri = project.resolve("src/agt/robot.asl").toUri().toString()
    project.resolve("robot.mas2j").writeText(
        "MAS robot { agents: robot [beliefs=\"limit(20)\"] agentArchClass argo.Arch; base; aslSourcePath: \"src/agt\"; }",
    )
    project.resolve("sketch").createDirectories().resolve("robot.ino").writeText(
        "void setup() {\n  javino.describe(F(\"dist(front|left, cm 0..400)\"));\n  javino.act[\"stop\"] = stop;\n}\n",
    )
    project.resolve("filters").createDirectories().resolve("near.xml").writeText("<PerceptionFilter/>")
    project.resolve("src/agt").createDirectories().resolve("base.asl").writeText("+!rest <- .wait(10).\n")
    project.resolve("src/agt/other.asl").writeText("+!x <- .send(robot, achieve, drive).\n")

    fun <T> at(marked: String, ask: Editor.(Int) -> T): T = Editor().use { editor ->
        editor.open(uri, marked.replace("§", ""))
        editor.ask(marked.indexOf('§'))
    }

    fun words(marked: String): List<String> = at(marked) { completions(uri, it).map { item -> item.label } }
    fun places(found: List<Location>) =
        found.map { "${it.uri.substringAfterLast('/')}:${it.range.start.line + 1}:${it.range.start.character + 1}" }

    test("what Jason refuses is told at its place, and gone once it is mended") {
        Editor().use { editor ->
            editor.open(uri, "+!a <- b(.\n+!c <- d.\n")
            editor.diagnostics(uri).first().range.start.line shouldBe 0
            editor.replace(uri, 7, 9, "b")
            editor.diagnostics(uri).filter { it.severity.value == 1 }.shouldBeEmpty()
        }
    }

    test("events and contexts are completed by the percepts of the board, with their meaning") {
        words("+§") shouldContain "dist"
        words("+!go : di§") shouldContain "dist"
        val item = at("+!go : di§") { completions(uri, it).first { item -> item.label == "dist" } }
        item.documentation.right.value shouldContain "dist(front|left, cm 0..400)"
    }

    test("a description of percepts that cannot be read is told once, with its file") {
        val sketch = project.resolve("sketch/other.ino").apply { writeText("javino.describe(\"Dist\");") }
        at("+§") {
            completions(uri, it)
            completions(uri, it)
            messages.toList()
        }.single() shouldContain "other.ino: \"Dist\" is no functor"
        sketch.deleteExisting()
    }

    test("goals are completed by goals of the program and of what it includes, and by nothing else") {
        val marked = "{ include(\"base.asl\") }\nfast.\n+!drive(Speed) <- !§.\n+!halt <- .print(1).\n"
        words(marked) shouldContainExactlyInAnyOrder listOf("drive", "halt", "rest")
    }

    test("arguments of ARGO's actions are completed by commands, filters, words and errors") {
        words("+!a <- argo.act(§).") shouldContainExactly listOf("stop")
        words("+!a <- argo.change_filter(n§).") shouldContainExactly listOf("near", "none")
        words("+!a <- argo.percepts(§).") shouldContainExactly listOf("open", "block", "close")
        words("-!a[error(§)] <- b.") shouldContainAll listOf("port_busy", "act_timeout")
        words("+!a <- argo.port(ttyACM0, [§]).") shouldContainAll listOf("baud", "as")
        words("+!a <- argo.act(stop, [urgent, §]).") shouldContainAll listOf("timeout", "latest")
    }

    test("internal actions are completed with their documentation, behind a dot too") {
        val items = at("+!a <- argo.§") { completions(uri, it) }
        items.first { it.label == "argo.act" }.documentation.right.value shouldContain "sends the text of W"
        at("+!a <- .pri§") { completions(uri, it).first { item -> item.label == ".print" } }.documentation.right.value shouldContain "print"
        words("+!a <- .§") shouldContain ".print"
    }

    test("nothing is completed in comments and strings") {
        words("// argo.§").shouldBeEmpty()
        words("+!a <- .print(\"argo.§\").").shouldBeEmpty()
    }

    test("a hover has the documentation of actions, errors, percepts and goals") {
        fun shown(marked: String) = at(marked) { hover(uri, it) }
        shown("+!a <- argo.a§ct(stop).").shouldNotBeNull() shouldContain "sends the text of W"
        shown("+!a <- argo.act(st§op).").shouldNotBeNull() shouldContain "robot.ino"
        shown("-!a[error(port_b§usy)] <- b.").shouldNotBeNull() shouldContain "another program holds it"
        shown("+di§st(front, Cm) <- a.").shouldNotBeNull() shouldContain "`dist(front|left, cm 0..400)`"
        shown("// Drives on.\n+!drive <- a.\n!dri§ve.").shouldNotBeNull().let {
            it shouldContain "Drives on."
            it shouldContain "1 plan, 1 use"
        }
        shown("+!a <- b. // no§thing") shouldBe null
    }

    test("definitions lead from goals to plans, from percepts and commands to the sketch, from names to filters and included files") {
        fun found(marked: String) = places(at(marked) { definitions(uri, it) })
        found("!dri§ve.\n+!drive : x <- a.\n+!drive <- b.\n-!drive <- c.") shouldContainExactly listOf("robot.asl:2:3", "robot.asl:3:3")
        found("{ include(\"base.asl\") }\n!re§st.") shouldContainExactly listOf("base.asl:1:3")
        found("+di§st(front, Cm) <- a.") shouldContainExactly listOf("robot.ino:2:22")
        found("+!a <- argo.act(st§op).") shouldContainExactly listOf("robot.ino:3:15")
        found("+!a <- argo.change_filter(ne§ar).") shouldContainExactly listOf("near.xml:1:1")
        found("{ include(\"ba§se.asl\") }") shouldContainExactly listOf("base.asl:1:1")
    }

    test("references are all places of a belief or a goal, and not those of another arity or kind") {
        places(at("go.\n!go.\n+!g§o <- ?go; !go; !go(1).\n") { references(uri, it) }) shouldContainExactly
            listOf("robot.asl:2:2", "robot.asl:3:3", "robot.asl:3:15")
    }

    test("a belief is renamed in all programs that are one, and messages of others that name it are told") {
        Editor().use { editor ->
            val text = "{ include(\"base.asl\") }\n!drive.\n+!drive : limit(20) <- !rest.\n"
            editor.open(uri, text)
            val renamed = editor.rename(uri, text.indexOf("rest"), "sleep")
            renamed.mapKeys { it.key.substringAfterLast('/') }.mapValues { it.value.size } shouldBe mapOf("robot.asl" to 1, "base.asl" to 1)
            editor.rename(uri, text.indexOf("drive"), "go").values.single().map { it.newText } shouldContainExactly listOf("go", "go")
            editor.messages.last() shouldContain "other.asl:1"
            editor.rename(uri, text.indexOf("limit"), "most")
            editor.messages.last() shouldContain "robot.mas2j:1"
        }
    }

    test("a percept of the board, a name in several namespaces and a name that Jason cannot read are refused with the reason") {
        fun refusal(marked: String, name: String) =
            shouldThrow<ExecutionException> { at(marked) { rename(uri, it, name) } }.cause?.message.shouldNotBeNull()
        refusal("+di§st(front, Cm) <- a.", "range") shouldContain "its name is in robot.ino"
        refusal("!g§o.\n+!left::go <- a.\n", "run") shouldContain "in several namespaces"
        refusal("!g§o.", "Run") shouldContain "Run cannot be the name of a goal"
    }

    test("the outline has beliefs, goals, plans with their contexts, and directives, of an unfinished program too") {
        val text = "{ include(\"base.asl\") }\nfast.\n!go.\n@p1 +!go : fast <- a.\n+dist(front, Cm) <- b.\n+!x <- c("
        val outline = at("$text§") { outline(uri) }
        outline.map { it.name } shouldContainAll listOf("fast", "!go", "+!go", "+dist(front, Cm)")
        outline.first { it.name == "+!go" }.detail shouldBe "fast"
        outline.map { it.name } shouldNotContain ""
    }

    test("the layout is made of edits of blanks") {
        at("+!a<-b( 1 ).§") { layout(uri) }.map { it.newText } shouldContainExactly listOf(" ", " ", "", "", "\n")
    }

    test("a text that is no file, whatever its name, is checked, and the texts behind it are") {
        Editor().use { editor ->
            listOf("untitled:robot:1.asl", "untitled:\u0000.asl", uri).forEach { each ->
                editor.open(each, "!drive")
                editor.diagnostics(each).map { it.code.left } shouldContain "syntax"
            }
        }
    }
})
