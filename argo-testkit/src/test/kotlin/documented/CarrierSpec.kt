import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.time.Duration.Companion.seconds

class CarrierSpec : FunSpec({
    test("what the sensors say stops the wheels") {
        val robot = autoClose(agent("carrier.asl"))
        robot.board("ttyACM1").shows("dist(front,9)")
        robot.shouldSend("stop")
        robot.board("ttyACM0").commands shouldBe listOf("stop")
    }

    test("sensors that hang stop the wheels, and wheels that hang do not stop the sensors") {
        val robot = autoClose(agent("carrier.asl"))
        robot.board("ttyACM1").shows("dist(front,90)")
        robot.shouldBelieve("sensors::dist(front,90)").board("ttyACM1").hangs()
        robot.shouldSend("stop", within = 2.seconds).board("ttyACM1").recovers()
        robot.board("ttyACM0").hangs()
        robot.board("ttyACM1").shows("dist(front,80)")
        robot.shouldBelieve("sensors::dist(front,80)")
    }
})
