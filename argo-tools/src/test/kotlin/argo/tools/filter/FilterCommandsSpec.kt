package argo.tools.filter

import argo.filters.format.JsonFilters
import argo.filters.format.XmlFilters
import argo.tools.Output
import argo.tools.argo
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive

class FilterCommandsSpec : FunSpec({
    val folder = tempdir()
    fun file(name: String, text: String) = folder.resolve(name).apply { writeText(text) }.path
    val front = file(
        "front.xml",
        """<PerceptionFilter onSwitch="freeze"><filter everyMs="100"><predicate>temp</predicate></filter>""" +
            """<filter arity="2"><predicate>dist</predicate><parameter operator="NE" id="0">f</parameter></filter></PerceptionFilter>""",
    )
    val broken = file("broken.xml", "<PerceptionFilter>\n<filter><predicate>Dist</predicate></filter>\n<rule/></PerceptionFilter>")

    test("check says what a filter does, or all that is wrong with it where") {
        val said = argo("filter", "check", front, broken)
        said.status shouldBe 1
        said.out shouldContain "$front: ok: filter front drops temp"
        said.err shouldContain "$broken:2:"
        said.err shouldContain "$broken:3:"
        argo("filter", "check", front).status shouldBe 0
    }

    test("check warns of what has no effect, and the exit status is 0") {
        val never = "<parameter operator=\"GT\" id=\"0\">5</parameter><parameter operator=\"LT\" id=\"0\">3</parameter>"
        val file = file("never.xml", "<PerceptionFilter><filter><predicate>d</predicate>$never</filter></PerceptionFilter>")
        val said = argo("filter", "check", file)
        val warning = "rule 1 (d where argument 0 is greater than 5 and argument 0 is less than 3) matches no percept: " +
            "argument 0 is greater than 5 and argument 0 is less than 3"
        said.status shouldBe 0
        said.out.lines()[1] shouldBe "$file: warning: $warning"
        val json = Json.parseToJsonElement(argo("filter", "check", file, front, "--json").out).jsonArray
        json.map { check -> check.jsonObject.getValue("warnings").jsonArray.map { it.jsonPrimitive.content } } shouldBe
            listOf(listOf(warning), emptyList())
    }

    test("a file of another name is refused with the names that filters have") {
        argo("filter", "check", file("none.txt", "")).err shouldContain "none.txt is no filter file: their names end in .xml or .json"
    }

    test("check goes on behind a file that is not there") {
        val said = argo("filter", "check", "no-such.xml", folder.path + "/gone.txt", front)
        said.status shouldBe 1
        said.err shouldContain "there is no file no-such.xml"
        said.err shouldContain "there is no file ${folder.path}/gone.txt"
        said.out shouldContain "front.xml: ok"
    }

    test("check takes a folder, and what is a filter in it") {
        val project = folder.resolve("project/filters").apply { mkdirs() }
        project.resolve("f.xml").writeText("""<PerceptionFilter><filter><predicat>d</predicat></filter></PerceptionFilter>""")
        project.resolve("g.json").writeText("""{"rules": [{"predicate": "d"}]}""")
        project.resolve("pom.xml").writeText("<project/>")
        project.resolve("package.json").writeText("{}")
        val said = argo("filter", "check", "${project.parent}")
        said.status shouldBe 1
        val (others, problems) = said.err.lines().filter(String::isNotEmpty).partition { "left out" in it }
        others.single() shouldStartWith "${project.parent}: left out, for they look like no filters: "
        listOf("pom.xml", "package.json").forEach { others.single() shouldContain "$project/$it" }
        problems.forEach { it shouldStartWith "$project/f.xml:1:" }
        said.out shouldBe "$project/g.json: ok: filter g drops d\n"
        val empty = folder.resolve("empty").apply { mkdirs() }
        argo("filter", "check", "$empty") shouldBe
            Output(1, "", "$empty:1:1: there is no filter in this folder: no file with <PerceptionFilter> in it, or with \"rules\"\n")
    }

    test("check refuses what is no regular file") {
        val pipe = "${folder.path}/pipe.json"
        check(ProcessBuilder("mkfifo", pipe).start().waitFor() == 0) { "no FIFO can be made" }
        val said = argo("filter", "check", pipe, front)
        said.status shouldBe 1
        said.err shouldContain "$pipe is no regular file"
        said.out shouldContain "front.xml: ok"
    }

    test("check prints JSON with every problem") {
        val (good, bad) = Json.parseToJsonElement(argo("filter", "check", front, broken, "--json").out).jsonArray.map { it.jsonObject }
        good.getValue("ok").jsonPrimitive.content shouldBe "true"
        bad.getValue("problems").jsonArray.map { it.jsonObject.getValue("line").jsonPrimitive.content } shouldBe listOf("2", "3")
    }

    test("explain names the rule that decides, for percepts and whole messages") {
        val said = argo("filter", "explain", front, "dist(b,3);dist(f,3);", "light(1)")
        said.status shouldBe 0
        said.out.lines()[0] shouldBe
            "dist(b,3) is dropped by filter front: it matches rule 2: dist where there are 2 arguments and argument 0 is not f"
        said.out.lines()[1] shouldContain "dist(f,3) is kept"
        said.out.lines()[2] shouldContain "light(1) is kept"
        val json = Json.parseToJsonElement(argo("filter", "explain", front, "dist(b,3)", "--json").out).jsonArray.single().jsonObject
        json.getValue("outcome").jsonPrimitive.content shouldBe "dropped"
    }

    test("convert keeps the filter what it is") {
        val filter = XmlFilters.read(java.io.File(front).readText(), front)
        val json = folder.resolve("converted.json")
        argo("filter", "convert", front, "--to", "json", "--out", json.path) shouldBe Output(0, "", "")
        JsonFilters.read(json.readText(), json.path) shouldBe filter
        XmlFilters.read(argo("filter", "convert", json.path, "--to", "xml").out, "back.xml") shouldBe filter
        argo("filter", "convert", front, "--to", "kotlin").out shouldContain "val front = dropFilter(\"front\", OnSwitch.FREEZE) {"
    }

    test("convert overwrites nothing, and says why a file cannot be read") {
        val there = file("there.json", "mine")
        val said = argo("filter", "convert", front, "--to", "json", "--out", there)
        said.status shouldBe 1
        said.err shouldContain "exists already, and is not overwritten"
        java.io.File(there).readText() shouldBe "mine"
        val refused = argo("filter", "convert", broken, "--to", "kotlin")
        refused.status shouldBe 1
        refused.err shouldContain "$broken:2:"
        refused.err shouldNotContain "\tat "
    }
})
