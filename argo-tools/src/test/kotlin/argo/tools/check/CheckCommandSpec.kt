package argo.tools.check

import argo.tools.argo
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

class CheckCommandSpec : FunSpec({
    val root = tempdir().toPath()
    fun folder(name: String, vararg files: Pair<String, String>): Path = root.resolve(name).apply {
        files.forEach { (file, text) -> resolve(file).apply { parent.createDirectories() }.writeText(text) }
    }
    val slips = folder(
        "slips", "robot.mas2j" to "MAS robot {\n  agents: robot agentArchClass argo.Arch;\n}",
        "robot.asl" to "!start.\n+!start <- .prnit(x).\n+dist(S,D) : D < 4 <- .print(D).\n",
    )
    fun JsonElement.text(name: String) = jsonObject.getValue(name).jsonPrimitive.content

    test("findings have their place, what is wrong, why, and what to do; the exit status is 0 unless a level is named") {
        val said = argo("check", "$slips")
        said.status shouldBe 0
        said.out shouldContain "robot.asl:2:12: error: there is no internal action .prnit [internal-action]\n" +
            "    the plan fails there; did you mean .print?\n"
        said.out shouldContain "2 files checked: 1 error, 0 warnings, 1 hint, which --hints shows\n"
        said.out shouldNotContain "variable S"
        argo("check", "$slips", "--hints").out shouldContain "3:7: hint: the variable S occurs once here"
        argo("check", "$slips", "--fail-on", "error").status shouldBe 1
        argo("check", "$slips/robot.mas2j", "--fail-on", "error").status shouldBe 1
        argo("check", "$slips", "--fail-on",
            "always").run { status to err.lines().first() } shouldBe (2 to "--fail-on is error, warning or hint, not always")
    }

    test("findings as JSON and SARIF have the same places") {
        val finding = Json.parseToJsonElement(argo("check", "$slips", "--json").out).jsonArray.first()
        listOf("line", "column", "endColumn", "level", "rule").map { finding.text(it) } shouldBe listOf("2", "12", "18", "error",
            "internal-action")
        val run = Json.parseToJsonElement(argo("check", "$slips", "--sarif").out).jsonObject.getValue("runs").jsonArray.single().jsonObject
        val result = run.getValue("results").jsonArray.first().jsonObject
        result.text("level") shouldBe "error"
        val place = result.getValue("locations").jsonArray.single().jsonObject.getValue("physicalLocation").jsonObject
        place.getValue("region").text("startLine") shouldBe "2"
        place.getValue("artifactLocation").text("uri") shouldContain "slips/robot.asl"
    }

    test("a folder without programs, a file that is not there and one of another kind are refused") {
        val empty = folder("empty", "a.txt" to "")
        argo("check", "$empty").err shouldBe "$empty has no program, .asl, and no project file, .mas2j\n"
        Files.createDirectory(empty.resolve("folder.asl"))
        argo("check", "$empty/folder.asl").err shouldBe "$empty/folder.asl has no program, .asl, and no project file, .mas2j\n"
        if (Files.exists(Path.of("/dev/null"))) {
            Files.createSymbolicLink(empty.resolve("device.asl"), Path.of("/dev/null"))
            argo("check", "$empty/device.asl").err shouldBe "$empty/device.asl is no regular file\n"
            argo("check", "$empty").out shouldContain "device.asl:1:1: warning: this is not checked: it is no regular file [left-out]"
        }
        argo("check", "$slips/none.asl").err shouldBe "there is no file $slips/none.asl\n"
        argo("check", "$empty/a.txt").err shouldBe "$empty/a.txt cannot be checked; files that can: .asl, .mas2j, .jcm\n"
    }

    test("the samples have no errors and no warnings") {
        listOf("../samples", "../experiment").forEach { argo("check", it).out shouldContain "0 errors, 0 warnings" }
    }

    test("a program is checked with the project that it belongs to, and a project file with its programs") {
        argo("check", "$slips/robot.mas2j").out shouldBe argo("check", "$slips").out
        argo("check", "$slips/robot.asl").out shouldContain "1 file checked: 1 error"
    }
})
