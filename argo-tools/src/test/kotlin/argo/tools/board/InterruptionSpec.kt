package argo.tools.board

import argo.tools.Output
import argo.tools.argo
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.LineRecording
import javino.sim.PseudoTerminals
import java.io.BufferedReader
import java.nio.file.LinkOption
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.exists
import kotlin.io.path.readSymbolicLink
import kotlin.io.path.writeText

/** Tests the effect of Ctrl-C on running commands. Sends SIGTERM, since background builds ignore SIGINT. */
class InterruptionSpec : FunSpec({
    val folder = tempdir().toPath()
    val board = folder.resolve("board.rec").apply { writeText("javino-recording 1\n0\tout\tgetPercepts\n0\tin\tdist(f,1);\n") }
    val signals: EnabledOrReasonIf = {
        if (System.getProperty("os.name").startsWith("Windows")) Enabled.disabled("Windows has no signals") else Enabled.enabled
    }
    val pairs: EnabledOrReasonIf = {
        if (PseudoTerminals.available()) Enabled.enabled else Enabled.disabled("there is no socat for a pseudo-terminal")
    }

    test("a monitoring that is interrupted ends with its summary and a whole recording").config(enabledOrReasonIf = signals) {
        val recorded = folder.resolve("mine.rec")
        tool("monitor", "replay:$board", "--interval", "0", "--record", "$recorded") { process, said ->
            said.readLine() shouldContain "dist(f,1)"
            process.toHandle().destroy() // process.destroy() would also close the output
            said.readText() shouldContain "recorded in $recorded"
            process.waitFor(LIMIT_S, TimeUnit.SECONDS) shouldBe true
            process.exitValue() shouldBe TERMINATED
        }
        LineRecording.read(recorded).received().first().message() shouldBe "dist(f,1);"
    }

    test("a replay that is interrupted takes its pseudo-terminal away").config(enabledOrReasonIf = pairs) {
        val link = folder.resolve("ttyBOARD")
        tool("replay", "$board", "--link", "$link") { process, said ->
            said.readLine() shouldBe "$link"
            said.readLine() shouldContain "argo.port(\"$link\") in an agent"
            val port = link.readSymbolicLink()
            port.exists() shouldBe true
            argo("replay", "$board", "--link", "$link") shouldBe Output(1, "", "$link exists already, and is not overwritten\n")
            process.toHandle().destroy() // process.destroy() would also close the output
            process.waitFor(LIMIT_S, TimeUnit.SECONDS) shouldBe true
            process.exitValue() shouldBe TERMINATED
            port.parent.exists() shouldBe false
            link.exists(LinkOption.NOFOLLOW_LINKS) shouldBe false
        }
    }

    test("a replay that is ended together with its pseudo-terminal says nothing of that").config(enabledOrReasonIf = pairs) {
        tool("replay", "$board") { process, said ->
            repeat(2) { said.readLine() }
            process.descendants().forEach { it.destroy() }
            process.toHandle().destroy()
            said.readText() shouldBe ""
        }
    }
})

private const val LIMIT_S = 60L
private const val TERMINATED = 128 + 15

/** Runs a tool in its own process, and ends the process. */
private fun tool(vararg arguments: String, use: (Process, BufferedReader) -> Unit) {
    val java = listOf(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC")
    val program = java + listOf("-cp", System.getProperty("java.class.path"), "argo.tools.MainKt")
    val process = ProcessBuilder(program + arguments).redirectErrorStream(true).start()
    try {
        process.inputReader().use { use(process, it) }
    } finally {
        process.destroyForcibly().waitFor()
    }
}
