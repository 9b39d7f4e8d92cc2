package samples.collision

import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.comparables.shouldBeLessThanOrEqualTo
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import javino.sim.PseudoTerminals
import samples.Program
import java.nio.file.Files
import java.nio.file.Path

private val stopped = Regex("""stopped (\d+\.\d) cm from the wall, \d+ ms after the (\d+) cm limit""")

class CollisionSpec : FunSpec({
    val pairs: EnabledOrReasonIf = {
        if (PseudoTerminals.available()) Enabled.enabled else Enabled.disabled(
            "there is no socat for a pseudo-terminal: install it with your package manager",
        )
    }

    context("at 9600 baud the agent stops the robot in front of the wall with the filter") {
        listOf("none", "frontSide", "frontDistance").forEach { filter ->
            test(filter).config(tags = if (filter == "none") emptySet() else thorough) {
                val (status, printed) = Program.run("collision", "--filter", filter, "--limit", "180")
                val (distance, limit) = withClue(printed) { stopped.find(printed).shouldNotBeNull().destructured }
                limit shouldBe "180"
                distance.toDouble() shouldBeLessThanOrEqualTo 180.0
                status shouldBe 0
            }
        }
    }

    test("the agent stops a robot whose sensors are on a board of their own") {
        val (status, printed) = Program.run("collision", "--filter", "none", "--boards", "2", "--limit", "180")
        withClue(printed) { stopped.find(printed).shouldNotBeNull() }
        status shouldBe 0
    }

    test("a terminal shows the robot on its way to the wall, and a dumb one plain lines").config(
        tags = thorough,
        enabledOrReasonIf = pairs,
    ) {
        fun printed(term: String) = Program.inTerminal(term, "collision", "--limit", "190").use { it.awaitEnd().printed }
        with(printed("xterm")) {
            Regex("""___?o=o>_*\|  distance 1\d\d\.\d cm""").containsMatchIn(this) shouldBe true
            lines().last() shouldContain stopped
        }
        with(printed("dumb")) {
            this shouldNotContain "o=o>"
            lines().first() shouldContain "distance 200.0 cm"
            lines().last() shouldContain stopped
        }
    }

    test("an agent that waits for the line inside its reasoning cycle runs into the wall without a filter").config(tags = thorough) {
        val (status, printed) = Program.run("collision", "--filter", "none", "--limit", "120", "--sensing", "in_cycle")
        printed.lines().last() shouldContain "ran into the wall: the agent had not stopped the robot"
        val log = logNamedIn(printed)
        Files.readString(log) shouldContain "in_cycle"
        Files.delete(log)
        status shouldBe 1
    }

    test("and with the front distance filter it does not").config(tags = thorough) {
        val (status, printed) = Program.run("collision", "--filter", "frontDistance", "--limit", "170", "--sensing", "in_cycle")
        printed shouldContain stopped
        status shouldBe 0
    }

    test("a port that cannot be opened ends the run with ARGO's reason") {
        val (status, printed) = Program.run("collision", "--port", "sim:elsewhere")
        printed shouldContain "there is no simulated board sim:elsewhere"
        Files.delete(logNamedIn(printed))
        status shouldBe 1
    }

    test("a port is taken as it is written, whatever characters it holds").config(tags = thorough) {
        val (status, printed) = Program.run("collision", "--port", """\\.\COM"10""")
        printed shouldContain """there is no port \\.\COM"10"""
        Files.delete(logNamedIn(printed))
        status shouldBe 1
    }

    test("of a real robot is told what its agent perceives") {
        val (status, printed) = Program.run("collision", "--port", "sim:robot", "--limit", "185")
        printed shouldContain Regex("""stopped: the front sensor says 1[78]\d\.0 cm, the limit is 185 cm""")
        printed shouldNotContain "log:"
        status shouldBe 0
    }

    test("a real robot is stopped when its run is interrupted").config(enabledOrReasonIf = pairs) {
        RealRobot().use { robot ->
            Program.samples("collision", "--port", robot.port).use { program ->
                robot.awaitState(Course.State.DRIVING)
                program.interrupt()
            }
            robot.awaitState(Course.State.STOPPED)
        }
    }

    test("a real robot that goes away ends the run with the reason").config(enabledOrReasonIf = pairs) {
        RealRobot().use { robot ->
            Program.samples("collision", "--port", robot.port).use { program ->
                robot.awaitState(Course.State.DRIVING)
                robot.unplug()
                val (status, printed) = program.awaitEnd()
                printed shouldContain Regex("port .* is gone|the board has gone")
                printed shouldContain "the robot on ${robot.port} may still drive: its agent could not send stop"
                Files.delete(logNamedIn(printed))
                status shouldBe 1
            }
        }
    }

    test("plain Jason runs the project").config(tags = thorough) {
        Program.jason("collision").use { jason ->
            jason.awaitLine("[robot] drives")
            // on a busy machine, the agent may stop the robot until its board answers again
            jason.awaitLine("[robot] stopped 3").shouldContain(Regex("""stopped 3\d\.\d cm from the wall"""))
        }
    }
})

private fun logNamedIn(printed: String): Path = Path.of(printed.lines().first { it.startsWith("log: ") }.removePrefix("log: "))

private val thorough = setOf(NamedTag("Thorough"))
