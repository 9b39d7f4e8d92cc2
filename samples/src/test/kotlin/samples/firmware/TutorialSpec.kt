package samples.firmware

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import samples.Program
import samples.documents.Document
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.readText
import kotlin.io.path.writeText

@Tags("Thorough")
class TutorialSpec : FunSpec({
    val root = Path.of("..").toRealPath()
    val page = Document.all(root).single { it.name == "docs/tutorial.md" }
    fun blocks(language: String) = page.snippets.filter { it.language == language }.map { it.text + "\n" }
    val (sensor, robot) = blocks("cpp")
    val folder = tempdir().toPath()
    val link = folder.resolve("ttyUNO")
    val compiles: EnabledOrReasonIf = { ifUnoCanBeSimulated() }
    fun board(sketch: String): Console {
        val file = folder.resolve("wall.ino").apply { writeText(sketch) }
        return Console("bash", "../argo", "board", "$file", "--link", "$link").also { it.await("port $link\n") }
    }

    test("step 1: the distance that is typed is the percept").config(enabledOrReasonIf = compiles) {
        board(sensor).use {
            it.type("8=60cm")
            it.await("8 in 60cm")
            tool("request", "$link", "getPercepts") shouldBe "dist(front,60);\n"
        }
    }

    test("step 2: commands move the motors, which stop when nothing more comes").config(enabledOrReasonIf = compiles) {
        board(robot).use {
            it.await("13 out HIGH")
            tool("send", "$link", "turn(left)") shouldBe "the board has acted\n"
            it.await("6 out PWM 150")
            it.await("13 out HIGH")
            tool("send", "$link", "turn(up)") shouldContain "refuses \"turn(up)\""
        }
    }

    test("step 3: the agent drives, turns away from a wall and drives on").config(enabledOrReasonIf = compiles) {
        val project = folder.resolve("project").createDirectory()
        project.resolve("robot.asl").writeText(blocks("agentspeak").single().replace("/tmp/ttyUNO", "$link"))
        project.resolve("wall.mas2j").writeText("MAS wall { agents: robot agentArchClass argo.Arch; }")
        project.resolve("logging.properties").writeText(root.resolve("samples/blink/logging.properties").readText())
        board(robot).use { uno ->
            uno.type("8=90cm")
            val classPath = System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")
            Program.start(project, "-cp", classPath, "jason.infra.local.RunLocalMAS", "wall.mas2j", "--no-net").use { agent ->
                agent.awaitLine("[robot] driving")
                uno.await("5 out PWM 150")
                uno.type("8=25cm")
                agent.awaitLine("[robot] a wall, 25 cm")
                uno.await("6 out PWM 150")
                uno.type("8=90cm")
                agent.awaitLine("[robot] driving")
                uno.await("5 out PWM 150")
                agent.interrupt()
            }
            uno.await("13 out HIGH")
        }
    }
})
