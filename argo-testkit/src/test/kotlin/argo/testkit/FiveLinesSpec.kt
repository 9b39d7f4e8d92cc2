package argo.testkit

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class FiveLinesSpec : FunSpec({
    test("a robot stops in front of a wall") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open).
            +dist(front,X) : X < 40 <- argo.act(stop).
            +dist(front,X) <- argo.act(front).
        """).use { robot ->
            robot.perceives("dist(front,90)").shouldSend("front").shouldBelieve("dist(front,90)").shouldNotSend("stop")
            robot.perceives("dist(front,30)").shouldSend("stop")
            robot.sent shouldBe listOf("front", "stop")
        }
    }
})
