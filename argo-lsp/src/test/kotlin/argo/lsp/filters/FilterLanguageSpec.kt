package argo.lsp.filters

import argo.lsp.Editor
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.io.path.writeText

private const val XML = "file:///filters/near.xml"
private const val JSON = "file:///filters/near.json"

/** In the texts of these tests, a `§` is the cursor. */
class FilterLanguageSpec : FunSpec({
    fun <T> at(uri: String, marked: String, ask: Editor.(Int) -> T): T = Editor().use { editor ->
        editor.open(uri, marked.replace("§", ""))
        editor.ask(marked.indexOf('§'))
    }

    fun words(uri: String, marked: String) = at(uri, marked) { completions(uri, it).map { item -> item.label } }

    test("the problems of a filter are told at their places, and are gone once it is mended") {
        Editor().use { editor ->
            val text = "<PerceptionFilter>\n  <filter><predicat>dist</predicat></filter>\n</PerceptionFilter>\n"
            editor.open(XML, text)
            val first = editor.diagnostics(XML).first { "predicat" in it.message.left }
            first.range.start.line shouldBe 1
            editor.replace(XML, 0, text.length, text.replace("predicat>", "predicate>"))
            editor.diagnostics(XML).shouldBeEmpty()
        }
    }

    test("a reflex that no board has is told of, as the editor has the filter") {
        val folder = tempdir().toPath()
        folder.resolve("robot.mas2j").writeText("MAS robot { agents: robot; }")
        folder.resolve("robot.ino").writeText("javino.act[\"stop\"] = stop;")
        val uri = folder.resolve("near.xml").toUri().toString()
        val text = "<PerceptionFilter><critical reflex=\"sotp\"><predicate>dist</predicate></critical></PerceptionFilter>"
        Editor().use { editor ->
            editor.open(uri, text)
            editor.diagnostics(uri).single().message.left shouldContain "did you mean stop?"
            editor.replace(uri, 0, text.length, text.replace("sotp", "stop"))
            editor.diagnostics(uri).shouldBeEmpty()
        }
    }

    test("parts of a filter without effect are warnings, and other XML and JSON is left alone") {
        Editor().use { editor ->
            editor.open(JSON, """{"rules": []}""")
            editor.diagnostics(JSON).single().message.left shouldContain "the filter has no rules"
            editor.open("file:///pom.xml", "<project><x></project>")
            editor.diagnostics("file:///pom.xml").shouldBeEmpty()
            editor.open("file:///.eslintrc.json", """{"rules": {"semi": "error"}}""")
            editor.diagnostics("file:///.eslintrc.json").shouldBeEmpty()
        }
    }

    test("elements, attributes and values are those of the schema at this place") {
        words(XML, "<§") shouldContainExactly listOf("PerceptionFilter")
        words(XML, "<PerceptionFilter><fil§") shouldContainExactly listOf("filter", "critical", "smooth")
        words(XML, "<PerceptionFilter><filter><!-- <a> --><predicate>a</predicate><§") shouldContainExactly
            listOf("parameter", "annotation", "predicate")
        words(XML, "<PerceptionFilter><filter ar§") shouldContainExactly listOf("arity", "everyMs", "deadband")
        words(XML, "<PerceptionFilter><filter><parameter id='0' operator=\"§\">3</parameter>") shouldContainExactly
            listOf("EQ", "NE", "GT", "GE", "LT", "LE", "IN", "MATCHES")
        words(XML, "<PerceptionFilter><smooth><parameter id='1' me§/>") shouldContainAll listOf("maxRate", "outliers", "among", "median")
        words(XML, "<PerceptionFilter><filter><parameter id='1' un§/>") shouldContainAll listOf("until", "deadband")
        words(XML, "<PerceptionFilter keep='§'") shouldContainExactly listOf("true", "false")
        words(XML, "<PerceptionFilter><filter></§") shouldContainExactly listOf("filter")
        words(XML, "<PerceptionFilter><filter/> § ").shouldBeEmpty()
    }

    test("members and values of JSON are those of the schema at this place") {
        words(JSON, """{"§""") shouldContainAll listOf("rules", "critical", "keep", "onSwitch")
        words(JSON, """{§""") shouldContainAll listOf("\"rules\"", "\"keep\"")
        words(JSON, """{"rules": [{"predicate": "a", "conditions": [{"argument": 0, "op§""") shouldContainAll listOf("operator", "value")
        words(JSON, """{"rules": [{"conditions": [{"operator": "§"}]}]}""") shouldContainAll listOf("EQ", "MATCHES")
        words(JSON, """{"smooth": [{"predicate": "a", "conditions": [{"argument": 0, "me§""") shouldContainAll
            listOf("maxRate", "outliers", "among", "median")
        words(JSON, """{"onSwitch": §}""") shouldContainExactly listOf("\"forget\"", "\"freeze\"")
        words(JSON, """{"keep": t§""") shouldContainExactly listOf("true", "false")
        words(JSON, """{"no": [{"§""").shouldBeEmpty()
    }

    test("a hover has the documentation of the schema") {
        at(XML, "<PerceptionFilter><filter><par§ameter id='0'/>") { hover(XML, it) }.shouldNotBeNull() shouldContain "on an argument"
        at(XML, "<PerceptionFilter on§Switch='freeze'>") { hover(XML, it) }.shouldNotBeNull() shouldContain "freeze keeps them"
        at(JSON, """{"rules": [{"every§Ms": 3}]}""") { hover(JSON, it) }.shouldNotBeNull() shouldContain "milliseconds"
        at(JSON, """{"nothing§": 3}""") { hover(JSON, it) } shouldBe null
    }
})
