package argo.tools.project

import argo.tools.Output
import argo.tools.argo
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import javino.sim.LineRecording
import java.io.StringReader
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

class NewCommandSpec : FunSpec({
    val folder = tempdir().toPath()
    val jar = folder.resolve("argo.jar").apply { writeText("jar") }
    val kit = folder.resolve("kit.jar").apply { writeText("kit") }
    fun new(name: String, vararg more: String) = argo("new", name, "--in", "$folder", "--argo-jar", "$jar", *more)

    test("a project is made in a folder of its name, and names itself as Jason and Arduino can") {
        new("My-robot", "--testkit-jar", "$kit").status shouldBe 0
        val project = folder.resolve("My-robot")
        project.resolve("my_robot.mas2j").readText() shouldContain "MAS my_robot {"
        project.resolve("sketch/my_robot/my_robot.ino").exists() shouldBe true
        project.resolve("lib/argo.jar").readText() shouldBe "jar"
        project.resolve("lib/argo-testkit.jar").readText() shouldBe "kit"
        project.resolve("pom.xml").readText() shouldContain "argo-testkit.jar"
    }

    test("a new project has nothing that check finds") {
        new("spotless").status shouldBe 0
        argo("check", "$folder/spotless") shouldBe Output(0, "4 files checked: 0 errors, 0 warnings, 0 hints\n", "")
    }

    test("a new project of two boards has a sketch and a recording for each, and nothing that check finds") {
        new("two-eyed", "--boards", "2", "--testkit-jar", "$kit").status shouldBe 0
        val project = folder.resolve("two-eyed")
        listOf("eyes", "lamp").forEach { project.resolve("sketch/two_eyed_$it/two_eyed_$it.ino").exists() shouldBe true }
        listOf("drive", "lamp").forEach { LineRecording.read(project.resolve("recordings/$it.rec")).isOfRequests shouldBe true }
        project.resolve("README.md").readText() shouldNotContain "@"
        argo("check", "$project").out shouldContain "0 errors, 0 warnings, 0 hints"
    }

    test("a folder that a shell would read as several words is printed in quotes") {
        folder.resolve("a b's").createDirectory()
        argo("new", "--in", "$folder/a b's", "--argo-jar", "$jar", "robot").out shouldContain "\"cd '$folder/a b'\\''s/robot'\", then"
    }

    test("a project of no boards, or three, is refused") {
        listOf("0", "3").forEach { new("many", "--boards", it).err shouldContain "--boards is 1 or 2, not $it" }
    }

    test("nothing that is there is overwritten, and no half project is left") {
        val there = folder.resolve("there").createDirectory().resolve("file").apply { writeText("mine") }
        val said = new("there")
        said.status shouldBe 1
        said.err shouldContain "exists already, and is not overwritten"
        there.readText() shouldBe "mine"
        folder.resolve("there").listDirectoryEntries().map { it.name } shouldBe listOf("file")
        folder.listDirectoryEntries(".*").shouldBeEmpty()
    }

    test("without the test kit there is no test of the agent, which is reported") {
        val said = new("plain")
        said.status shouldBe 0
        said.err shouldContain "there is no argo-testkit.jar beside argo.jar"
        val project = folder.resolve("plain")
        project.resolve("src/test/kotlin").listDirectoryEntries().map { it.name } shouldBe listOf("RobotFiltersSpec.kt")
        project.resolve("pom.xml").readText() shouldNotContain "argo-testkit.jar</systemPath>"
    }

    test("a missing jar or folder is reported") {
        argo("new", "x", "--in", "$folder", "--argo-jar", "no.jar").err shouldContain "there is no file no.jar"
        argo("new", "x", "--in", "$folder/none", "--argo-jar", "$jar").err shouldBe "there is no folder $folder/none\n"
        argo("new", "x", "--in", "$jar", "--argo-jar", "$jar").err shouldBe "$jar is no folder\n"
        new("x", "--testkit-jar", "no.jar").err shouldContain "there is no file no.jar"
        folder.listDirectoryEntries().map { it.name } shouldNotContain "x"
    }

    test("names that a file system, Jason or Arduino could not have are refused") {
        val refused = listOf("", ".", "..", "a/b", "a b", "-a", "7up", "é", "x".repeat(61), "CON", "lpt1", "agents", "a.b")
        refused.filter { ProjectName.problem(it) == null }.shouldBeEmpty()
        listOf("a", "my-robot", "Robot_2", "console").mapNotNull(ProjectName::problem).shouldBeEmpty()
    }

    test("the files hold no placeholder, and the recording can be replayed") {
        val files = projectFiles(ProjectName("a-b"), withTestKit = true)
        files.values.filter { Regex("@[A-Z_]+@") in it }.shouldBeEmpty()
        val recording = LineRecording.read(StringReader(files.getValue("recordings/drive.rec")), "drive.rec")
        recording.isOfRequests shouldBe true
        files.keys shouldContain "src/test/kotlin/RobotSpec.kt"
    }

    test("a new project is made for the versions that this build has") {
        val pom = Path.of("../pom.xml").readText()
        mapOf("jason" to JASON_VERSION, "kotlin" to KOTLIN_VERSION, "kotest" to KOTEST_VERSION).forEach { (name, version) ->
            pom shouldContain "<$name.version>$version</$name.version>"
        }
    }
})
