package samples.firmware

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.ActionRefusedException
import javino.Link
import javino.LinkSettings
import javino.Protocol
import samples.Program

/** The agents of the samples drive the real firmware, over jSerialComm, from end to end. */
class FirmwareSpec : FunSpec({
    val built: EnabledOrReasonIf = {
        if (SimulatedUno.isBuilt()) Enabled.enabled else Enabled.disabled("the firmware is not built: ./argo firmware says what it needs")
    }

    test("the LED on pin 13 follows argo.act(ledOn) and argo.act(ledOff)").config(enabledOrReasonIf = built) {
        SimulatedUno("Blink").use { uno ->
            uno.watch(LED)
            Program.samples("blink", "--port", uno.port, "--seconds", "20").use {
                repeat(3) {
                    uno.awaitPin(LED, "high")
                    uno.awaitPin(LED, "low")
                }
            }
        }
    }

    test("what an analogue input measures becomes a percept, and the agent stops the motors").config(enabledOrReasonIf = built) {
        SimulatedUno("Robot4WD").use { robot ->
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

    test("in version 2 the board says that it has acted, and refuses what it does not know").config(enabledOrReasonIf = built) {
        SimulatedUno("Blink").use { uno ->
            uno.watch(LED)
            Link.open(uno.port, LinkSettings.defaults().withProtocol(Protocol.AUTO), "the test").use { link ->
                link.request("getPercepts", ANSWER_LIMIT_MS).text() shouldContain "ledStatus(off)"
                link.protocol() shouldBe Protocol.V2
                link.sendAndAwait("ledOn", ANSWER_LIMIT_MS)
                uno.awaitPin(LED, "high")
                shouldThrow<ActionRefusedException> { link.sendAndAwait("fly", ANSWER_LIMIT_MS) }
                link.request("getPercepts(ledStatus)", ANSWER_LIMIT_MS).text() shouldContain "ledStatus(on)"
            }
        }
    }

    test("the motors stop by themselves when the Java machine is killed").config(enabledOrReasonIf = built) {
        SimulatedUno("Robot4WD").use { robot ->
            robot.setMillivolts(FRONT_DISTANCE, TWO_METRES_MV)
            robot.watch(LEFT_FORWARD)
            Program.samples("collision", "--port", robot.port).use { robot.awaitPin(LEFT_FORWARD, "high") } // kills it
            robot.awaitPin(LEFT_FORWARD, "low")
        }
    }
})

private const val LED = 13
private const val ANSWER_LIMIT_MS = 20_000
private const val LEFT_FORWARD = 7
private const val FRONT_DISTANCE = "A0"

// The sonar gives Vcc/512 an inch: 5000 mV / 512 / 2.54 for a centimetre.
private const val TWO_METRES_MV = 769
private const val THIRTY_CM_MV = 118
