package samples.bare

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import javino.sim.PseudoTerminals
import samples.Program
import java.io.File
import java.nio.file.Path

/** The tools without Jason: `java -jar argo.jar`. */
class JarToolsSpec : FunSpec({
    val folder = tempdir().toPath()
    val jar = System.getProperty("argo.jar").let { Path.of(it).toAbsolutePath().normalize().toString() }
    val pairs: EnabledOrReasonIf = {
        if (PseudoTerminals.available()) Enabled.enabled else Enabled.disabled("there is no socat for a pseudo-terminal")
    }
    val recording = folder.resolve("drive.rec").toFile().apply {
        writeText("javino-recording 1\n0\tout\tgetPercepts\n5\tin\tdist(f,30);\n905\tin\tdist(f,20);\n")
    }

    test("the jar runs, and prints its version") {
        val said = Program.run(folder, "-jar", jar, "--version")
        said.status shouldBe 0
        said.printed shouldContain Regex("ARGO \\d+\\.\\d+\\.\\d+, Java ")
    }

    test("it looks at ports, filters and the machine without Jason") {
        Program.run(folder, "-jar", jar, "ports", "--json").status shouldBe 0
        Program.run(folder, "-jar", jar, "doctor").printed shouldContain "the serial driver's native library runs"
        folder.resolve("f.json").toFile().writeText("""{"rules": [{"predicate": "dist", "arity": 1}]}""")
        Program.run(folder, "-jar", jar, "filter", "convert", "f.json", "--to", "kotlin")
            .printed shouldContain "drop(\"dist\") { arity(1) }"
        val refused = Program.run(folder, "-jar", jar, "fly")
        refused.status shouldBe 2
        refused.printed shouldContain "there is no command 'fly'"
        refused.printed shouldContain "java -jar argo.jar --help lists the options"
    }

    test("an interrupted monitor tells what it has seen") {
        Program.start(folder, "-jar", jar, "monitor", "replay:$recording", "--interval", "10").use { monitor ->
            monitor.awaitLine("dist(f,20)")
            val said = monitor.interrupt()
            withClue(said.printed) {
                said.printed shouldContain " messages in "
                said.printed shouldContain "dist(f,_): "
                said.printed shouldNotContain "Exception"
            }
        }
    }

    test("a reader that has seen enough ends it quietly") {
        val command = "${thisJava().program} -jar $jar monitor replay:$recording --interval 10 | head -n 2"
        val said = Program.run(ProcessBuilder("sh", "-c", command).directory(folder.toFile()))
        said.status shouldBe 0
        said.printed.lines().filter { it.isNotEmpty() }.size shouldBe 2
    }

    test("a recording is a board on a pseudo-terminal, with its commands shown, until Ctrl-C").config(enabledOrReasonIf = pairs) {
        Program.start(folder, "-jar", jar, "replay", "$recording").use { replay ->
            val port = replay.awaitLine("/").trim()
            Program.run(folder, "-jar", jar, "request", port, "getPercepts").printed shouldContain "dist(f,30);"
            Program.run(folder, "-jar", jar, "send", port, "ledOn").printed shouldContain "the board has taken the command"
            replay.awaitLine("command: ledOn")
            withClue(replay.interrupt().printed) { File(port).exists() shouldBe false }
        }
    }

    test("what a board said unasked is said from its beginning when somebody listens").config(enabledOrReasonIf = pairs) {
        val spoken = folder.resolve("spoken.rec").toFile().apply { writeText("javino-recording 1\n0\tin\tdist(1);\n300\tin\tdist(2);\n") }
        Program.start(folder, "-jar", jar, "replay", "$spoken").use { replay ->
            val port = replay.awaitLine("/").trim()
            val heard = Program.run(folder, "-jar", jar, "monitor", port, "--mode", "listen", "--count", "2", "--timeout", "5000")
            withClue(heard.printed) {
                heard.status shouldBe 0
                heard.printed.lines().take(2).map { it.substringAfterLast("  ") } shouldBe listOf("dist(1)", "dist(2)")
            }
        }
    }
})
