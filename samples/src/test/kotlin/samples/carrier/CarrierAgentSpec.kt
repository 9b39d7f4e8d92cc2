package samples.carrier

import argo.testkit.AgentSetUp
import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.io.path.Path
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/** The agent of the sample on three simulated boards. */
class CarrierAgentSpec : FunSpec({
    fun AgentSetUp.plugIn() {
        options("beliefs" to """boards([port(wheels,[as(wheels)]), port(sensors,[as(sensors)]), port(arm,[as(arm)])])""")
        board("wheels").version2().knows("forward", "backward", "halt").shows("moving(no)", "way(0)")
        board("sensors").version2().shows("dist(front,60)")
        board("arm").version2().knows("grip", "release", "halt").shows("hand(open)")
    }
    fun carrier() = agent(Path("three-boards/carrier.asl")) { plugIn() }

    fun TestAgent.driving() = apply {
        shouldSend("forward", within = 5.seconds)
        board("wheels").shows("moving(forward)", "way(10)")
        shouldBelieve("wheels::moving(forward)")
    }

    test("it halts before the can and has the arm grip it") {
        carrier().use { robot ->
            robot.driving().board("sensors").shows("dist(front,10)")
            robot.shouldSend("halt")
            robot.board("wheels").commands shouldBe listOf("forward", "halt")
            robot.board("wheels").shows("moving(no)", "way(50)")
            robot.shouldSend("grip")
            robot.board("arm").commands shouldBe listOf("grip")
        }
    }

    test("it halts when it does not see any more") {
        carrier().use { robot ->
            robot.driving().board("sensors").hangs()
            robot.shouldSend("halt", within = 3.seconds)
            robot.board("wheels").commands shouldBe listOf("forward", "halt")
        }
    }

    test("an arm that hangs keeps it from nothing but gripping") {
        carrier().use { robot ->
            robot.driving().board("arm").hangs()
            robot.board("sensors").shows("dist(front,9)")
            robot.shouldSend("halt", within = 100.milliseconds)
        }
    }
})
