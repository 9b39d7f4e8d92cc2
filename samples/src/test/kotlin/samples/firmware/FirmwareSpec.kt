package samples.firmware

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.spec.style.scopes.FunSpecContainerScope
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.ActionRefusedException
import javino.Protocol
import javino.link.Link
import javino.link.LinkSettings
import samples.Program
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText

/** Agents use the real firmware over jSerialComm, on each kind of board. */
class FirmwareSpec : FunSpec({
    context("on an Uno") { agentsDrive(BoardKind.UNO, "Robot4WD") }
    context("on a Cortex-M3") { agentsDrive(BoardKind.CORTEX_M, "robot") }
    context("on a RISC-V microcontroller") { agentsDrive(BoardKind.RISC_V, "robot") }

    test("on an Uno the lamp of the robot lights in the dark and goes off in the light").config(
        enabledOrReasonIf = built(BoardKind.UNO, "Robot4WD"),
    ) {
        SimulatedBoard("Robot4WD").use { robot ->
            robot.setMillivolts(FRONT_DISTANCE, TWO_METRES_MV)
            robot.setMillivolts(LIGHT, DARK_MV)
            robot.watch(LIGHT_LAMP)
            Program.samples("collision", "--port", robot.port, "--filter", "none").use {
                robot.awaitPin(LIGHT_LAMP, "high")
                robot.setMillivolts(LIGHT, BRIGHT_MV)
                robot.awaitPin(LIGHT_LAMP, "low")
            }
        }
    }
})

private fun built(kind: BoardKind, vararg programs: String): EnabledOrReasonIf = {
    if (kind.isBuilt(*programs)) Enabled.enabled
    else Enabled.disabled("the firmware is not built: ./argo firmware says what it needs")
}

private suspend fun FunSpecContainerScope.agentsDrive(kind: BoardKind, robotProgram: String) {
    val built = built(kind, "Blink", "Echo", robotProgram)

    test("the LED on pin 13 follows argo.act(ledOn) and argo.act(ledOff)").config(enabledOrReasonIf = built) {
        SimulatedBoard("Blink", kind).use { board ->
            board.watch(LED)
            Program.samples("blink", "--port", board.port, "--seconds", "20").use {
                repeat(3) {
                    board.awaitPin(LED, "high")
                    board.awaitPin(LED, "low")
                }
            }
        }
    }

    test("what an analogue input measures becomes a percept, and the agent stops the motors").config(
        tags = thorough,
        enabledOrReasonIf = built,
    ) {
        SimulatedBoard(robotProgram, kind).use { robot ->
            robot.setMillivolts(FRONT_DISTANCE, TWO_METRES_MV)
            robot.watch(LEFT_FORWARD)
            Program.samples("collision", "--port", robot.port, "--limit", "40").use { program ->
                robot.awaitPin(LEFT_FORWARD, "high")
                robot.setMillivolts(FRONT_DISTANCE, THIRTY_CM_MV)
                robot.awaitPin(LEFT_FORWARD, "low")
                val (status, printed) = program.awaitEnd()
                printed shouldContain Regex("stopped: the front sensor says (29|30|31)(\\.\\d)? cm, the limit is 40 cm")
                status shouldBe 0
            }
        }
    }

    test("in version 2 the board says that it has acted, and refuses what it does not know").config(
        tags = thorough,
        enabledOrReasonIf = built,
    ) {
        SimulatedBoard("Blink", kind).use { board ->
            board.watch(LED)
            Link.open(board.port, LinkSettings.defaults().withProtocol(Protocol.AUTO), "the test").use { link ->
                link.request("getPercepts", ANSWER_LIMIT_MS).text() shouldContain "ledStatus(off)"
                link.protocol() shouldBe Protocol.V2
                link.sendAndAwait("ledOn", ANSWER_LIMIT_MS)
                board.awaitPin(LED, "high")
                shouldThrow<ActionRefusedException> { link.sendAndAwait("fly", ANSWER_LIMIT_MS) }
                link.request("getPercepts(ledStatus)", ANSWER_LIMIT_MS).text() shouldContain "ledStatus(on)"
            }
        }
    }

    test("the motors stop by themselves when the Java machine is killed").config(tags = thorough, enabledOrReasonIf = built) {
        SimulatedBoard(robotProgram, kind).use { robot ->
            robot.setMillivolts(FRONT_DISTANCE, TWO_METRES_MV)
            robot.watch(LEFT_FORWARD)
            Program.samples("collision", "--port", robot.port).use { robot.awaitPin(LEFT_FORWARD, "high") } // kills the program
            robot.awaitPin(LEFT_FORWARD, "low")
        }
    }

    test("at one damaged byte in 200 in both directions each command is carried out once, in order").config(
        tags = thorough,
        enabledOrReasonIf = built,
    ) {
        SimulatedBoard("Echo", kind).use { board ->
            DamagedLine(board.port).use { line ->
                board.watch(DUTY)
                board.watch(LED)
                withJason("counting", counting(line.port)) { it.awaitLine("all carried out") }
                line.damaged shouldBeGreaterThan 0
            }
            board.watch(FENCE)
            val changes = generateSequence { board.awaitChange() }.takeWhile { !it.startsWith("pin $FENCE ") }.toList()
            changes.filter { it.startsWith("pin $DUTY ") }.drop(1) shouldBe SPEEDS.map { "pin $DUTY pwm $it" }
            changes.filter { it.startsWith("pin $LED ") }.drop(1) shouldHaveSize SPEEDS.count()
        }
    }
}

/** Writes an agent that sends commands one by one, each after the outcome of the last. */
private fun counting(port: String) = """
    !start.
    +!start <- argo.port("$port"); !send(${SPEEDS.first}).
    +!send(N) : N <= ${SPEEDS.last} <- argo.act(speed(N)); !send(N + 1).
    +!send(_) <- .print("all carried out"); .stopMAS.
    -!send(N)[error_msg(Why)] <- .print("failed at ", N, ": ", Why); .stopMAS.
""".trimIndent()

private fun withJason(name: String, agent: String, test: (Program) -> Unit) {
    val folder = createTempDirectory(name)
    try {
        folder.resolve("$name.mas2j").writeText("MAS $name { agents: $name agentArchClass argo.Arch; }")
        folder.resolve("$name.asl").writeText(agent)
        Path.of("blink/logging.properties").copyTo(folder.resolve("logging.properties"))
        Program.start("jason.infra.local.RunLocalMAS", "$name.mas2j", "--no-net", directory = folder).use(test)
    } finally {
        folder.toFile().deleteRecursively()
    }
}

private const val LED = 13
private const val DUTY = 5
private const val FENCE = 6 // an unused pin, whose report follows all earlier changes
private val SPEEDS = 10..109
private const val ANSWER_LIMIT_MS = 20_000
private const val LEFT_FORWARD = 7
private const val FRONT_DISTANCE = "A0"
private const val LIGHT = "A4"
private const val LIGHT_LAMP = 11

// The agent's limit is level 100 of 1023, which is 489 mV.
private const val DARK_MV = 4500
private const val BRIGHT_MV = 300

// The sonar gives Vcc/512 per inch: 5000 mV / 512 / 2.54 per centimetre.
private const val TWO_METRES_MV = 769
private const val THIRTY_CM_MV = 118

private val thorough = setOf(NamedTag("Thorough"))
